#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/mesh/triangle_mesh.h"

namespace ossuary::mesh {

/// The undirected edges of a mesh, each with the triangle sides that lie on it. A side is numbered
/// 3 * triangle + corner and goes from that corner to the next one. Triangles that name a vertex
/// twice have no sides. Edges are in order of (a, b).
struct EdgeTable {
    struct Edge {
        std::uint32_t a = 0;  ///< the smaller vertex index
        std::uint32_t b = 0;
        std::uint32_t first_side = 0;  ///< into `sides`
        std::uint32_t side_count = 0;
    };
    std::vector<Edge> edges;
    std::vector<std::uint32_t> sides;  ///< grouped by edge, in ascending order within an edge

    [[nodiscard]] std::span<const std::uint32_t> sides_of(const Edge& edge) const {
        return {sides.data() + edge.first_side, edge.side_count};
    }
};

/// Linear in the number of triangles (but for vertices with very many edges, which are sorted).
EdgeTable build_edge_table(const TriangleMesh& mesh);

/// Edges of more than two triangles; what the table would say, in seven tenths of the time.
std::size_t count_non_manifold_edges(const TriangleMesh& mesh);

/// Whether no two triangles run along an edge in the same direction, as on a surface that is
/// oriented and has no edge of more than two triangles.
bool sides_agree(const TriangleMesh& mesh);

/// True when the side goes from the smaller to the larger vertex index.
inline bool goes_up(const TriangleMesh& mesh, std::uint32_t side) {
    const TriangleMesh::Triangle& triangle = mesh.triangles[side / 3];
    return triangle[side % 3] < triangle[(side % 3 + 1) % 3];
}

inline constexpr std::uint32_t kNoTriangle = 0xFFFFFFFFu;

/// For each triangle the one across each of its three sides; kNoTriangle on boundaries and where
/// other than two triangles meet.
std::vector<std::array<std::uint32_t, 3>> adjacent_triangles(const TriangleMesh& mesh,
                                                             const EdgeTable& table);

}  // namespace ossuary::mesh
