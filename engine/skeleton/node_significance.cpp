#include "engine/skeleton/node_significance.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <nanoflann.hpp>

namespace ossuary {
namespace {

/// What nanoflann asks of a point set.
struct SurfacePoints {
    std::span<const Vec3> points;

    [[nodiscard]] std::size_t kdtree_get_point_count() const { return points.size(); }
    [[nodiscard]] double kdtree_get_pt(std::size_t i, std::size_t axis) const {
        return points[i][static_cast<Eigen::Index>(axis)];
    }
    template <typename Box>
    bool kdtree_get_bbox(Box& /*box*/) const {
        return false;
    }
};

using SurfaceTree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, SurfacePoints>,
                                        SurfacePoints, 3, std::uint32_t>;

}  // namespace

std::vector<double> surface_distance_sums(const SkeletonGraph& graph, std::span<const Vec3> surface,
                                          std::size_t closest) {
    std::vector<double> sums(graph.nodes.size(), 0.0);
    if (surface.empty() || closest == 0) return sums;
    const SurfacePoints points{surface};
    const SurfaceTree tree(3, points, nanoflann::KDTreeSingleIndexAdaptorParams(32));
    const std::size_t count = std::min(closest, surface.size());
    std::vector<std::uint32_t> indices(count);
    std::vector<double> squared(count);
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
        const std::size_t found =
            tree.knnSearch(graph.nodes[i].position.data(), count, indices.data(), squared.data());
        for (std::size_t k = 0; k < found; ++k) sums[i] += std::sqrt(squared[k]);
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

}  // namespace ossuary
