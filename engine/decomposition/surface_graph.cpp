#include "engine/decomposition/surface_graph.h"

#include "engine/mesh/edge_table.h"
#include "engine/mesh/measures.h"
#include "engine/mesh/vertex_normals.h"

namespace ossuary::decomposition {

SurfaceGraph surface_graph(const mesh::TriangleMesh& mesh) {
    SurfaceGraph graph;
    graph.across = mesh::adjacent_triangles(mesh, mesh::build_edge_table(mesh));
    graph.normals = mesh::triangle_normals(mesh);
    graph.areas = mesh::triangle_areas(mesh);
    const std::size_t count = mesh.triangles.size();
    graph.centers.reserve(count);
    for (std::size_t t = 0; t < count; ++t) {
        const auto [a, b, c] = mesh.corners(t);
        graph.centers.emplace_back((a + b + c) / 3.0);
        graph.total_area += graph.areas[t];
    }
    graph.turns.resize(count);
    graph.side_lengths.resize(count);
    for (std::size_t t = 0; t < count; ++t) {
        const auto corners = mesh.corners(t);
        for (std::size_t side = 0; side < 3; ++side) {
            graph.turns[t][side] = 0.0F;
            graph.side_lengths[t][side] =
                static_cast<float>((corners[(side + 1) % 3] - corners[side]).norm());
            const std::uint32_t other = graph.across[t][side];
            if (other == mesh::kNoTriangle) continue;
            const Vec3 bend = graph.normals[t] - graph.normals[other];
            const bool concave = (graph.centers[other] - graph.centers[t]).dot(bend) > 0.0;
            graph.turns[t][side] = static_cast<float>(concave ? bend.norm() : -bend.norm());
        }
    }
    return graph;
}

SurfacePieces surface_pieces(const SurfaceGraph& graph) {
    constexpr std::uint32_t kNone = 0xFFFFFFFFU;
    SurfacePieces pieces;
    pieces.of_triangle.assign(graph.size(), kNone);
    std::vector<std::uint32_t> open;
    for (std::uint32_t start = 0; start < graph.size(); ++start) {
        if (pieces.of_triangle[start] != kNone) continue;
        const auto piece = static_cast<std::uint32_t>(pieces.areas.size());
        pieces.areas.push_back(0.0);
        pieces.of_triangle[start] = piece;
        open.push_back(start);
        while (!open.empty()) {
            const std::uint32_t t = open.back();
            open.pop_back();
            pieces.areas[piece] += graph.areas[t];
            for (const std::uint32_t other : graph.across[t]) {
                if (other == mesh::kNoTriangle || pieces.of_triangle[other] != kNone) continue;
                pieces.of_triangle[other] = piece;
                open.push_back(other);
            }
        }
    }
    return pieces;
}

}  // namespace ossuary::decomposition
