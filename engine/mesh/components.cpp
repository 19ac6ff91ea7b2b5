#include "engine/mesh/components.h"

#include <limits>

#include "engine/mesh/disjoint_sets.h"

namespace ossuary::mesh {

MeshComponents connected_components(const TriangleMesh& mesh) {
    DisjointSets sets(mesh.vertices.size());
    for (const TriangleMesh::Triangle& triangle : mesh.triangles) {
        sets.unite(triangle[0], triangle[1]);
        sets.unite(triangle[0], triangle[2]);
    }
    constexpr std::uint32_t kUnnumbered = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> number(mesh.vertices.size(), kUnnumbered);
    MeshComponents components;
    components.of_triangle.reserve(mesh.triangles.size());
    for (const TriangleMesh::Triangle& triangle : mesh.triangles) {
        std::uint32_t& component = number[sets.find(triangle[0])];
        if (component == kUnnumbered) component = components.count++;
        components.of_triangle.push_back(component);
    }
    return components;
}

}  // namespace ossuary::mesh
