#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/mesh/triangle_mesh.h"

namespace ossuary::mesh {

/// A mesh whose vertices are parted so that each is surrounded by one fan of triangles.
struct ManifoldFans {
    std::vector<std::uint32_t> source_vertex;             ///< of each new vertex
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< new vertices
    std::size_t dropped_triangles = 0;                    ///< that named a vertex twice
    std::size_t duplicated_vertices = 0;
};

/// Glues triangles along edges that exactly two of them share in opposite directions, and parts
/// them everywhere else. Unused vertices are left out.
ManifoldFans part_into_fans(const TriangleMesh& mesh);

}  // namespace ossuary::mesh
