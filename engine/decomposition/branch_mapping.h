#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/core/geometry.h"
#include "engine/skeleton/skeleton_graph.h"

namespace ossuary::decomposition {

/// Finds the branch of a skeleton that a point of the surface belongs to (thesis sec. 3.4.1): with
/// n_i the vector from a skeleton vertex to the point, n_j the surface's normal there and d_p the
/// distance, the vertex with the least
///   d_r = d_n * d_p,   d_n = |n_i| |n_j| / (n_i . n_j)                        (eq. 3.7 - 3.9)
/// wins, of equal ones the nearest. Vertices that the surface does not face away from
/// (n_i . n_j <= 0) are out, unless all are: then the nearest wins. Exact, and seldom by looking at
/// all vertices: d_r >= d_p, so the nearest few bound how far away a better one can be.
class BranchMapping {
public:
    /// @param skeleton  in the units of the points; nodes belong to the first branch that ends
    /// there
    explicit BranchMapping(const skeleton::SkeletonGraph& skeleton);
    ~BranchMapping();
    BranchMapping(const BranchMapping&) = delete;
    BranchMapping& operator=(const BranchMapping&) = delete;

    /// @pre the skeleton has a branch
    [[nodiscard]] std::uint32_t branch_of(const Vec3& point, const Vec3& normal) const;

    /// The vertex of the skeleton that is nearest to the point.
    /// @pre the skeleton has a branch
    [[nodiscard]] const Vec3& nearest(const Vec3& point) const;

private:
    struct Tree;
    std::vector<Vec3> vertices_;
    std::vector<std::uint32_t> branches_;
    std::unique_ptr<Tree> tree_;
};

}  // namespace ossuary::decomposition
