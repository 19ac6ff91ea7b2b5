#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "engine/mesh/disjoint_sets.h"
#include "engine/mesh/triangle_mesh.h"

namespace ossuary::mesh {

/// Triangles in groups that lie apart from each other.
struct NearbyGroups {
    std::uint32_t count = 0;
    std::vector<std::uint32_t> of;  ///< for each triangle looked at; numbered by their first one
};

/// Finds what lies apart at the scale of a box, by cells: triangles that are at most `reach` from
/// each other along every axis are in one group, triangles 1.5 times that far along some axis are
/// so only through others. Keeps its buffers from one call to the next.
class NearbyGrouper {
public:
    /// @param axes   of the box, as columns, orthonormal
    /// @param reach  share of the longest side of the triangles' box, in [1/48, 1/4]
    NearbyGrouper(const TriangleMesh& mesh, const Mat3& axes, double reach);

    /// Groups some of the triangles. All are in one group where their box has no extent, where
    /// telling them apart would take longer than about a second, and when `stop` is requested.
    [[nodiscard]] NearbyGroups group(std::span<const std::uint32_t> triangles,
                                     const std::stop_token& stop = {});

    /// The box of some of the triangles, along the axes.
    [[nodiscard]] Box3 box_of(std::span<const std::uint32_t> triangles) const;

private:
    [[nodiscard]] std::uint32_t cell_of(const Vec3& position) const;
    std::uint32_t occupy(const Vec3& position);
    void occupy_corners(std::span<const std::uint32_t> triangles);
    bool occupy_insides(std::span<const std::uint32_t> triangles, const std::stop_token& stop);
    /// The number of groups.
    std::uint32_t link_neighbors();
    [[nodiscard]] NearbyGroups numbered(std::span<const std::uint32_t> triangles);
    void clear();

    const TriangleMesh& mesh_;
    std::vector<Vec3> positions_;  ///< of the vertices, along the axes
    std::uint32_t cells_along_;    ///< the longest side of the box
    Vec3 low_ = Vec3::Zero();
    double cell_size_ = 0.0;
    std::vector<std::uint32_t> place_of_;  ///< for each cell, in `occupied_`
    std::vector<std::uint32_t> occupied_;  ///< cells
    DisjointSets sets_{0};                 ///< of occupied cells
};

}  // namespace ossuary::mesh
