#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/geometry.h"
#include "engine/mesh/triangle_mesh.h"

namespace ossuary::decomposition {

/// The vertices of a surface with their neighbours along edges, normals and curvature.
struct VertexGraph {
    std::vector<std::uint32_t> first;  ///< of each vertex, and one past the last
    std::vector<std::uint32_t> neighbors;
    std::vector<Vec3> normals;  ///< unit length; zero where no triangle with area meets
    /// Mean over the edges of the normal curvature along them, times the square root of the area;
    /// positive where the surface is convex.
    std::vector<double> curvatures;

    [[nodiscard]] std::size_t size() const { return normals.size(); }
    [[nodiscard]] std::span<const std::uint32_t> around(std::uint32_t vertex) const {
        return {neighbors.data() + first[vertex], first[vertex + 1] - first[vertex]};
    }
};

/// @param mesh  vertices told apart by index: weld a soup first
VertexGraph vertex_graph(const mesh::TriangleMesh& mesh);

}  // namespace ossuary::decomposition
