#include "engine/mesh/manifold_fans.h"

#include <limits>

#include "engine/mesh/disjoint_sets.h"
#include "engine/mesh/edge_table.h"

namespace ossuary::mesh {

ManifoldFans part_into_fans(const TriangleMesh& mesh) {
    // Corners of triangles that belong to one vertex of the result; two sides glued to each other
    // join the corners at both ends. Side s runs from corner s to the next one of its triangle.
    DisjointSets corners(3 * mesh.triangles.size());
    const auto next_corner = [](std::uint32_t corner) {
        return corner % 3 == 2 ? corner - 2 : corner + 1;
    };
    const EdgeTable table = build_edge_table(mesh);
    for (const EdgeTable::Edge& edge : table.edges) {
        if (edge.side_count != 2) continue;
        const auto sides = table.sides_of(edge);
        if (goes_up(mesh, sides[0]) == goes_up(mesh, sides[1])) continue;
        corners.unite(sides[0], next_corner(sides[1]));
        corners.unite(sides[1], next_corner(sides[0]));
    }
    constexpr std::uint32_t kUnnumbered = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> number(3 * mesh.triangles.size(), kUnnumbered);
    std::vector<std::uint32_t> copies(mesh.vertices.size(), 0);
    ManifoldFans fans;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const TriangleMesh::Triangle& triangle = mesh.triangles[t];
        if (triangle[0] == triangle[1] || triangle[1] == triangle[2] ||
            triangle[2] == triangle[0]) {
            ++fans.dropped_triangles;
            continue;
        }
        std::array<std::uint32_t, 3> parted{};
        for (std::uint32_t corner = 0; corner < 3; ++corner) {
            std::uint32_t& vertex = number[corners.find(3 * t + corner)];
            if (vertex == kUnnumbered) {
                vertex = static_cast<std::uint32_t>(fans.source_vertex.size());
                fans.source_vertex.push_back(triangle[corner]);
                if (copies[triangle[corner]]++ > 0) ++fans.duplicated_vertices;
            }
            parted[corner] = vertex;
        }
        fans.triangles.push_back(parted);
    }
    return fans;
}

}  // namespace ossuary::mesh
