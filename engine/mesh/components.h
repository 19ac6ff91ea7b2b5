#pragma once

#include <cstdint>
#include <vector>

#include "engine/mesh/triangle_mesh.h"

namespace ossuary::mesh {

/// The pieces of a surface: triangles that share a vertex belong together.
struct MeshComponents {
    std::uint32_t count = 0;
    std::vector<std::uint32_t> of_triangle;  ///< numbered by their first triangle
};

/// Finds the pieces by shared vertex indices; weld a soup first (weld.h).
MeshComponents connected_components(const TriangleMesh& mesh);

}  // namespace ossuary::mesh
