#include "engine/skeleton/refine.h"

#include <array>
#include <string>

#include "engine/skeleton/graph_surgery.h"
#include "engine/skeleton/node_significance.h"
#include "engine/skeleton/prune_protrusion.h"
#include "engine/skeleton/prune_significance.h"

namespace ossuary::skeleton {
namespace {

struct PruningMethodName {
    PruningMethod method;
    std::string_view name;
};
constexpr std::array kPruningMethodNames = {
    PruningMethodName{PruningMethod::kProtrusion, "protrusion"},
    PruningMethodName{PruningMethod::kSignificance, "significance"},
    PruningMethodName{PruningMethod::kNone, "none"},
};

void prune(SkeletonGraph& graph, std::span<const Vec3> surface, const RefineOptions& options,
           const std::stop_token& stop) {
    switch (options.pruning) {
        case PruningMethod::kProtrusion:
            prune_by_protrusion(
                graph, {options.min_protrusion, options.max_leaves, options.merge_junctions}, stop);
            break;
        case PruningMethod::kSignificance:
            prune_by_significance(graph, surface, options.significance_scale, stop);
            break;
        case PruningMethod::kNone:
            break;
    }
}

void smooth_once(SkeletonGraph& graph, SkeletonGraph::Branch& branch, double variance) {
    const bool closed_curve = branch.a == branch.b && graph.nodes[branch.a].degree == 2;
    if (closed_curve) {
        smooth_closed_branch(branch, graph.nodes[branch.a], variance);
    } else {
        smooth_branch(branch, variance);
    }
}

}  // namespace

std::string_view to_string(PruningMethod method) {
    for (const PruningMethodName& entry : kPruningMethodNames) {
        if (entry.method == method) return entry.name;
    }
    return "none";
}

Result<PruningMethod> parse_pruning_method(std::string_view name) {
    for (const PruningMethodName& entry : kPruningMethodNames) {
        if (entry.name == name) return entry.method;
    }
    return {ErrorCode::kInvalidArgument, "pruning method: found '" + std::string(name) +
                                             "', expected 'protrusion', 'significance' or 'none'"};
}

RefinedSkeleton refine(const SkeletonGraph& thinned, std::span<const Vec3> surface,
                       const RefineOptions& options, const std::stop_token& stop) {
    RefinedSkeleton result;
    result.pruned = thinned;  // step 1: decomposed at the junctions when the graph was made
    join_degree_two_nodes(result.pruned);
    prune(result.pruned, surface, options, stop);  // steps 2-4
    update_degrees(result.pruned);
    std::vector<double> distance_sums;
    if (options.significance) {
        distance_sums = surface_distance_sums(result.pruned, surface, stop);
        set_significance(result.pruned, distance_sums);
    }

    result.refined = result.pruned;
    if (!options.smooth) return result;
    for (SkeletonGraph::Branch& branch : result.refined.branches) {
        if (stop.stop_requested()) break;
        smooth_once(result.refined, branch, options.presmooth_variance);
        // Steps 5 and 6.
        smooth_once(result.refined, branch,
                    smoothing_variance(branch, options.smoothing_scale, options.max_variance));
    }
    // Smoothing moves no node but those of closed curves, which are of degree 2 and count nothing.
    if (options.significance) set_significance(result.refined, distance_sums);
    return result;
}

}  // namespace ossuary::skeleton
