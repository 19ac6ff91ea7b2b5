#include "engine/decomposition/branch_mapping.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nanoflann.hpp>

namespace ossuary::decomposition {
namespace {

constexpr std::size_t kFirstLook = 16;

/// How nanoflann sees the vertices.
struct Points {
    const std::vector<Vec3>& vertices;
    [[nodiscard]] std::size_t kdtree_get_point_count() const { return vertices.size(); }
    [[nodiscard]] double kdtree_get_pt(std::size_t index, std::size_t axis) const {
        return vertices[index][static_cast<Eigen::Index>(axis)];
    }
    template <typename Box>
    bool kdtree_get_bbox(Box&) const {
        return false;
    }
};

}  // namespace

struct BranchMapping::Tree {
    using Index = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Points>,
                                                      Points, 3, std::size_t>;
    explicit Tree(const std::vector<Vec3>& vertices) : points{vertices}, index(3, points) {
        index.buildIndex();
    }
    Points points;
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
    std::vector<std::size_t> found;
    std::vector<double> squared;
    std::size_t nearest = 0, best = vertices_.size();
    double best_distance = std::numeric_limits<double>::infinity();
    std::size_t looked_at = 0;
    for (std::size_t wanted = kFirstLook; looked_at < vertices_.size(); wanted *= 4) {
        const std::size_t count = std::min(wanted, vertices_.size());
        found.resize(count);
        squared.resize(count);
        tree_->index.knnSearch(point.data(), count, found.data(), squared.data());
        nearest = found[0];
        for (std::size_t k = looked_at; k < count; ++k) {
            const double facing = (point - vertices_[found[k]]).dot(normal);
            if (facing <= 0.0) continue;
            const double distance = squared[k] / facing;  // |n_i|^2 / (n_i . n_j), |n_j| = 1
            if (distance >= best_distance) continue;
            best_distance = distance;
            best = found[k];
        }
        looked_at = count;
        if (std::sqrt(squared[count - 1]) >= best_distance) break;
    }
    return branches_[best == vertices_.size() ? nearest : best];
}

const Vec3& BranchMapping::nearest(const Vec3& point) const {
    std::size_t found = 0;
    double squared = 0.0;
    tree_->index.knnSearch(point.data(), 1, &found, &squared);
    return vertices_[found];
}

}  // namespace ossuary::decomposition
