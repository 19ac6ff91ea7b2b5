#include "engine/skeleton/prune_protrusion.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "engine/skeleton/graph_surgery.h"

namespace ossuary::skeleton {
namespace {

struct RankedLeaf {
    Leaf leaf;
    double protrusion = std::numeric_limits<double>::infinity();
};

std::optional<RankedLeaf> least_protruding(const SkeletonGraph& graph) {
    std::optional<RankedLeaf> least;
    for (const Leaf& leaf : leaves(graph)) {
        const double value = protrusion(graph, leaf.branch, leaf.junction);
        if (!least || value < least->protrusion) least = {leaf, value};
    }
    return least;
}

void prune_below(SkeletonGraph& graph, double threshold, const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        const auto least = least_protruding(graph);
        if (!least || least->protrusion >= threshold) return;
        remove_leaf(graph, least->leaf);
    }
}

/// Shortest first, so that a chain of junctions within one ball meets in its middle.
void merge_junctions(SkeletonGraph& graph, const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        std::optional<std::uint32_t> shortest;
        double shortest_length = std::numeric_limits<double>::infinity();
        for (std::uint32_t i = 0; i < graph.branches.size(); ++i) {
            const SkeletonGraph::Branch& branch = graph.branches[i];
            const SkeletonGraph::Node& a = graph.nodes[branch.a];
            const SkeletonGraph::Node& b = graph.nodes[branch.b];
            if (branch.a == branch.b || a.degree < 3 || b.degree < 3) continue;
            const double length = branch.length();
            if (length < std::max(a.radius, b.radius) && length < shortest_length) {
                shortest = i;
                shortest_length = length;
            }
        }
        if (!shortest) return;
        contract_branch(graph, *shortest);
    }
}

}  // namespace

double protrusion(const SkeletonGraph& graph, std::uint32_t branch, std::uint32_t junction) {
    const SkeletonGraph::Branch& b = graph.branches[branch];
    const std::size_t count = b.points.size();
    const bool forward = b.a == junction;
    double arc = 0.0;
    double reach = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = forward ? i : count - 1 - i;
        if (i > 0) arc += (b.points[at] - b.points[forward ? at - 1 : at + 1]).norm();
        reach = std::max(reach, arc + b.radii[at]);
    }
    const double radius = graph.nodes[junction].radius;
    return radius > 0.0 ? reach / radius : std::numeric_limits<double>::infinity();
}

void prune_by_protrusion(SkeletonGraph& graph, const ProtrusionOptions& options,
                         const std::stop_token& stop) {
    join_degree_two_nodes(graph);
    double threshold = options.min_protrusion;
    prune_below(graph, threshold, stop);
    if (options.merge_junctions) {
        merge_junctions(graph, stop);
        prune_below(graph, threshold, stop);
    }
    while (static_cast<int>(leaves(graph).size()) > options.max_leaves && !stop.stop_requested()) {
        const auto least = least_protruding(graph);
        // To the next threshold of the geometric series that removes something.
        if (!(least->protrusion < std::numeric_limits<double>::infinity())) return;
        while (threshold <= least->protrusion) threshold *= 1.1;
        prune_below(graph, threshold, stop);
        if (options.merge_junctions) {
            merge_junctions(graph, stop);
            prune_below(graph, threshold, stop);
        }
    }
}

}  // namespace ossuary::skeleton
