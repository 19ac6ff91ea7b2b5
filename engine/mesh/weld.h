#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "engine/mesh/triangle_mesh.h"

namespace ossuary::mesh {

struct WeldOptions {
    /// Vertices at most this far from an earlier one, in parts of the bounding box's diagonal, are
    /// merged into it. 0 merges equal positions only.
    double tolerance = 0.0;
    /// Those farther apart than `sure_tolerance`, in the same parts, only where that is less than
    /// this share of the shortest edge at either.
    double edge_share = std::numeric_limits<double>::infinity();
    double sure_tolerance = 0.0;
    /// Leave out triangles whose corners fall together.
    bool drop_collapsed = true;
};

struct WeldResult {
    TriangleMesh mesh;                           ///< vertices in order of first use; none unused
    std::vector<std::uint32_t> source_triangle;  ///< of each triangle, in the input
    std::vector<std::uint32_t> vertex_of;        ///< of each vertex of the input; kUnused for none
    std::size_t merged_vertices = 0;
    std::size_t dropped_triangles = 0;

    static constexpr std::uint32_t kUnused = 0xFFFFFFFFU;
};

/// Joins vertices that lie together, so that the triangles of a soup know their neighbours, and
/// leaves out unused vertices.
WeldResult weld(const TriangleMesh& mesh, const WeldOptions& options = {});

}  // namespace ossuary::mesh
