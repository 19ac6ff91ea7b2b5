#include "engine/mesh/inspect.h"

#include <string>

#include "engine/mesh/components.h"
#include "engine/mesh/disjoint_sets.h"
#include "engine/mesh/edge_table.h"
#include "engine/mesh/measures.h"

namespace ossuary::mesh {
namespace {

std::size_t count_degenerate_faces(const TriangleMesh& mesh) {
    std::size_t count = 0;
    std::uint32_t last_face = 0xFFFFFFFFu;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (!is_degenerate(mesh, t)) continue;
        const bool mapped = t < mesh.face_of_triangle.size();
        if (mapped && mesh.face_of_triangle[t] == last_face) continue;
        if (mapped) last_face = mesh.face_of_triangle[t];
        ++count;
    }
    return count;
}

std::size_t count_unreferenced(const TriangleMesh& mesh) {
    std::vector<std::uint8_t> used(mesh.vertices.size(), 0);
    for (const TriangleMesh::Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) used[vertex] = 1;
    }
    std::size_t unused = 0;
    for (const std::uint8_t mark : used) unused += mark == 0 ? 1 : 0;
    return unused;
}

/// Corners at the same vertex belong to one fan when edges of two triangles link them.
std::size_t count_non_manifold_vertices(const TriangleMesh& mesh, const EdgeTable& table) {
    DisjointSets fans(3 * mesh.triangles.size());
    const auto corner_at = [&](std::uint32_t triangle, std::uint32_t vertex) {
        std::uint32_t corner = 0;
        while (mesh.triangles[triangle][corner] != vertex) ++corner;
        return 3 * triangle + corner;
    };
    std::vector<std::uint8_t> has_side(mesh.triangles.size(), 0);
    for (const EdgeTable::Edge& edge : table.edges) {
        const auto sides = table.sides_of(edge);
        for (const std::uint32_t side : sides) has_side[side / 3] = 1;
        for (std::size_t i = 1; i < sides.size(); ++i) {
            for (const std::uint32_t vertex : {edge.a, edge.b}) {
                fans.unite(corner_at(sides[0] / 3, vertex), corner_at(sides[i] / 3, vertex));
            }
        }
    }
    std::vector<std::uint8_t> fan_count(mesh.vertices.size(), 0);
    std::size_t count = 0;
    for (std::uint32_t corner = 0; corner < 3 * mesh.triangles.size(); ++corner) {
        if (has_side[corner / 3] == 0 || fans.find(corner) != corner) continue;
        std::uint8_t& fans_here = fan_count[mesh.triangles[corner / 3][corner % 3]];
        if (fans_here < 2 && ++fans_here == 2) ++count;
    }
    return count;
}

}  // namespace

MeshReport inspect(const TriangleMesh& mesh) {
    const EdgeTable table = build_edge_table(mesh);
    MeshReport report;
    report.vertices = mesh.vertices.size();
    report.unreferenced_vertices = count_unreferenced(mesh);
    report.triangles = mesh.triangles.size();
    report.edges = table.edges.size();
    std::size_t sides = 0;
    std::vector<std::uint8_t> on_edge(mesh.vertices.size(), 0);
    for (const EdgeTable::Edge& edge : table.edges) {
        on_edge[edge.a] = on_edge[edge.b] = 1;
        sides += edge.side_count;
        if (edge.side_count == 1) ++report.boundary_edges;
        if (edge.side_count > 2) ++report.non_manifold_edges;
        if (edge.side_count != 2) continue;
        const auto both = table.sides_of(edge);
        if (goes_up(mesh, both[0]) == goes_up(mesh, both[1])) ++report.misoriented_edges;
    }
    report.non_manifold_vertices = count_non_manifold_vertices(mesh, table);
    report.degenerate_faces = count_degenerate_faces(mesh);
    report.components = connected_components(mesh).count;
    for (const std::uint8_t mark : on_edge) report.euler_characteristic += mark;
    report.euler_characteristic -= static_cast<long long>(table.edges.size());
    report.euler_characteristic += static_cast<long long>(sides / 3);

    report.closed = sides > 0 && report.boundary_edges == 0;
    report.edge_manifold = report.non_manifold_edges == 0;
    report.manifold = report.edge_manifold && report.non_manifold_vertices == 0;
    report.oriented = report.misoriented_edges == 0;
    if (report.closed && report.manifold && report.oriented && 3 * report.triangles == sides) {
        report.genus = static_cast<long long>(report.components) - report.euler_characteristic / 2;
    }
    return report;
}

std::vector<MeshWarning> surface_warnings(const TriangleMesh& mesh) {
    std::vector<MeshWarning> warnings;
    const auto warn = [&](const char* code, std::size_t count, const char* noun) {
        if (count == 0) return;
        warnings.push_back({code, count, std::to_string(count) + " " + noun});
    };
    if (mesh.empty()) {
        warnings.push_back({"no_triangles", 1, "the mesh has no triangles"});
        return warnings;
    }
    warn("degenerate_faces", count_degenerate_faces(mesh), "faces without area");
    warn("non_manifold_edges", count_non_manifold_edges(mesh),
         "edges where more than two faces meet");
    warn("unreferenced_vertices", count_unreferenced(mesh), "vertices that no face uses");
    return warnings;
}

}  // namespace ossuary::mesh
