#include "engine/decomposition/branch_mapping.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nanoflann.hpp>
#include <tuple>
#include <utility>

#include "engine/voxel/point_set.h"

namespace ossuary::decomposition {
namespace {

constexpr std::size_t kFirstLook = 16;

}  // namespace

struct BranchMapping::Tree {
    using Index =
        nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, voxel::PointSet>,
                                            voxel::PointSet, 3, std::size_t>;
    explicit Tree(const std::vector<Vec3>& vertices) : points{vertices}, index(3, points) {
        index.buildIndex();
    }
    voxel::PointSet points;
    Index index;
};

BranchMapping::BranchMapping(const skeleton::SkeletonGraph& skeleton) {
    std::vector<bool> node_taken(skeleton.nodes.size(), false);
    for (std::uint32_t b = 0; b < skeleton.branches.size(); ++b) {
        const skeleton::SkeletonGraph::Branch& branch = skeleton.branches[b];
        for (std::size_t k = 0; k < branch.points.size(); ++k) {
            const bool is_end = k == 0 || k + 1 == branch.points.size();
            if (is_end) {
                const std::uint32_t node = k == 0 ? branch.a : branch.b;
                if (node_taken[node]) continue;
                node_taken[node] = true;
            }
            vertices_.push_back(branch.points[k]);
            branches_.push_back(b);
        }
    }
    if (!vertices_.empty()) tree_ = std::make_unique<Tree>(vertices_);
}

BranchMapping::~BranchMapping() = default;

std::uint32_t BranchMapping::branch_of(const Vec3& point, const Vec3& normal) const {
    struct Best {
        double mapped = std::numeric_limits<double>::infinity();   // d_r
        double squared = std::numeric_limits<double>::infinity();  // d_p^2
        std::size_t vertex = 0;
        [[nodiscard]] auto key() const { return std::tie(mapped, squared, vertex); }
    };
    Best best;
    const auto look_at = [&](std::size_t vertex, double squared) {
        const double facing = (point - vertices_[vertex]).dot(normal);
        if (facing <= 0.0) return;
        const Best candidate{squared / facing, squared, vertex};  // |n_j| = 1
        if (candidate.key() < best.key()) best = candidate;
    };
    const std::size_t count = std::min(kFirstLook, vertices_.size());
    std::array<std::size_t, kFirstLook> nearest{};
    std::array<double, kFirstLook> squared{};
    tree_->index.knnSearch(point.data(), count, nearest.data(), squared.data());
    for (std::size_t k = 0; k < count; ++k) look_at(nearest[k], squared[k]);
    if (best.mapped == std::numeric_limits<double>::infinity()) {
        for (std::size_t v = 0; v < vertices_.size(); ++v) {
            look_at(v, (point - vertices_[v]).squaredNorm());
        }
    } else if (best.mapped > std::sqrt(squared[count - 1]) && count < vertices_.size()) {
        std::vector<std::pair<std::size_t, double>> within;
        tree_->index.radiusSearch(point.data(), best.mapped * best.mapped, within, {});
        for (const auto& [vertex, distance] : within) look_at(vertex, distance);
    }
    const bool none = best.mapped == std::numeric_limits<double>::infinity();
    return branches_[none ? nearest[0] : best.vertex];
}

const Vec3& BranchMapping::nearest(const Vec3& point) const {
    std::size_t found = 0;
    double squared = 0.0;
    tree_->index.knnSearch(point.data(), 1, &found, &squared);
    return vertices_[found];
}

}  // namespace ossuary::decomposition
