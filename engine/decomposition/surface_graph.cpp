#include "engine/decomposition/surface_graph.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/mesh/edge_table.h"
#include "engine/mesh/measures.h"
#include "engine/mesh/vertex_normals.h"

namespace ossuary::decomposition {
namespace {

/// Below this height, in parts of the square root of the area, a triangle's normal is noise.
constexpr double kSliver = 1e-4;

std::vector<std::uint32_t> first_triangles_of_faces(const mesh::TriangleMesh& mesh,
                                                    bool whole_faces) {
    constexpr std::uint32_t kNone = 0xFFFFFFFFU;
    std::vector<std::uint32_t> first(mesh.triangles.size());
    const bool mapped = whole_faces && mesh.face_of_triangle.size() == first.size();
    std::vector<std::uint32_t> first_of(mapped ? mesh.face_count : 0, kNone);
    for (std::uint32_t t = 0; t < first.size(); ++t) {
        first[t] = t;
        if (!mapped) continue;
        std::uint32_t& known = first_of[mesh.face_of_triangle[t]];
        if (known == kNone) known = t;
        first[t] = known;
    }
    return first;
}

double height_of(const SurfaceGraph& graph, std::size_t t) {
    const auto& sides = graph.side_lengths[t];
    const auto longest = static_cast<double>(*std::max_element(sides.begin(), sides.end()));
    return longest > 0.0 ? 2.0 * graph.areas[t] / longest : 0.0;
}

/// Gives slivers the mean normal of the triangles across their sides, weighted by the sides'
/// lengths: first those that have one of their own, then from sliver to sliver. Slivers among
/// themselves keep theirs.
void lend_normals_to_slivers(SurfaceGraph& graph) {
    const double least = kSliver * std::sqrt(graph.total_area);
    std::vector<std::uint8_t> lacks(graph.size(), 0);
    std::vector<std::uint32_t> reached;
    for (std::uint32_t t = 0; t < graph.size(); ++t) {
        lacks[t] = height_of(graph, t) < least ? 1 : 0;
        if (lacks[t] != 0) reached.push_back(t);
    }
    while (!reached.empty()) {
        std::vector<std::pair<std::uint32_t, Vec3>> lent;
        for (const std::uint32_t t : reached) {
            if (lacks[t] == 0) continue;
            Vec3 sum = Vec3::Zero();
            for (std::size_t side = 0; side < 3; ++side) {
                const std::uint32_t other = graph.across[t][side];
                if (other == mesh::kNoTriangle || lacks[other] != 0) continue;
                sum += static_cast<double>(graph.side_lengths[t][side]) * graph.normals[other];
            }
            if (!sum.isZero()) lent.emplace_back(t, sum.stableNormalized());
        }
        reached.clear();
        for (const auto& [t, normal] : lent) {
            graph.normals[t] = normal;
            lacks[t] = 0;
            for (const std::uint32_t other : graph.across[t]) {
                if (other != mesh::kNoTriangle && lacks[other] != 0) reached.push_back(other);
            }
        }
    }
}

void measure_turns(SurfaceGraph& graph) {
    graph.turns.assign(graph.size(), {0.0F, 0.0F, 0.0F});
    for (std::size_t t = 0; t < graph.size(); ++t) {
        for (std::size_t side = 0; side < 3; ++side) {
            const std::uint32_t other = graph.across[t][side];
            if (other == mesh::kNoTriangle) continue;
            const Vec3 bend = graph.normals[t] - graph.normals[other];
            const bool concave = (graph.centers[other] - graph.centers[t]).dot(bend) > 0.0;
            graph.turns[t][side] = static_cast<float>(concave ? bend.norm() : -bend.norm());
        }
    }
}

}  // namespace

SurfaceGraph surface_graph(const mesh::TriangleMesh& mesh, bool whole_faces) {
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
    graph.first_of_face = first_triangles_of_faces(mesh, whole_faces);
    graph.side_lengths.resize(count);
    for (std::size_t t = 0; t < count; ++t) {
        const auto corners = mesh.corners(t);
        for (std::size_t side = 0; side < 3; ++side) {
            graph.side_lengths[t][side] =
                static_cast<float>((corners[(side + 1) % 3] - corners[side]).norm());
        }
    }
    lend_normals_to_slivers(graph);
    measure_turns(graph);
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
