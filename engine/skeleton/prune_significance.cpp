#include "engine/skeleton/prune_significance.h"

#include <algorithm>

#include "engine/skeleton/graph_surgery.h"
#include "engine/skeleton/node_significance.h"

namespace ossuary::skeleton {
namespace {

/// The mean of S / degree over the nodes of a degree other than 0 and 2.
double mean_significance_per_degree(const SkeletonGraph& graph) {
    double sum = 0.0;
    int count = 0;
    for (const SkeletonGraph::Node& node : graph.nodes) {
        if (node.degree == 0 || node.degree == 2) continue;
        sum += node.significance / node.degree;
        ++count;
    }
    return count > 0 ? sum / count : 0.0;
}

}  // namespace

void prune_by_significance(SkeletonGraph& graph, std::span<const Vec3> surface,
                           double significance_scale, const std::stop_token& stop) {
    join_degree_two_nodes(graph);
    // Nodes do not move here: one search for each, and the sums follow the nodes' numbering.
    std::vector<double> sums = surface_distance_sums(graph, surface, stop);
    while (!stop.stop_requested()) {
        set_significance(graph, sums);
        const double threshold = mean_significance_per_degree(graph) / significance_scale;
        const std::vector<Leaf> all = leaves(graph);
        const auto least =
            std::min_element(all.begin(), all.end(), [&](const Leaf& a, const Leaf& b) {
                return graph.nodes[a.tip].significance < graph.nodes[b.tip].significance;
            });
        if (least == all.end() || graph.nodes[least->tip].significance >= threshold) return;
        const bool dissolves = graph.nodes[least->junction].degree == 3;
        const std::size_t nodes_before = graph.nodes.size();
        const Leaf leaf = *least;
        remove_leaf(graph, leaf);
        // The tip went, then the junction if it was dissolved: the indices shift accordingly.
        const std::uint32_t junction = leaf.junction;
        if (dissolves && nodes_before - graph.nodes.size() == 2) {
            sums.erase(sums.begin() + std::max(leaf.tip, junction));
            sums.erase(sums.begin() + std::min(leaf.tip, junction));
        } else {
            sums.erase(sums.begin() + leaf.tip);
        }
    }
}

}  // namespace ossuary::skeleton
