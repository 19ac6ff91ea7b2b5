#include "engine/mesh/vertex_normals.h"

#include <cmath>

#include "engine/mesh/measures.h"

namespace ossuary::mesh {

std::vector<Vec3> triangle_normals(const TriangleMesh& mesh) {
    std::vector<Vec3> normals(mesh.triangles.size(), Vec3::Zero());
    for (std::size_t t = 0; t < normals.size(); ++t) {
        if (is_degenerate(mesh, t)) continue;
        const auto [a, b, c] = mesh.corners(t);
        // Edges are scaled first: products of very small or large ones leave the range of double.
        normals[t] = (b - a).stableNormalized().cross((c - a).stableNormalized()).normalized();
    }
    return normals;
}

std::vector<Vec3> vertex_normals(const TriangleMesh& mesh) {
    const std::vector<Vec3> of_triangle = triangle_normals(mesh);
    std::vector<Vec3> normals(mesh.vertices.size(), Vec3::Zero());
    for (std::size_t t = 0; t < of_triangle.size(); ++t) {
        const auto corners = mesh.corners(t);
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 forward = (corners[(i + 1) % 3] - corners[i]).stableNormalized();
            const Vec3 back = (corners[(i + 2) % 3] - corners[i]).stableNormalized();
            const double angle = std::atan2(forward.cross(back).norm(), forward.dot(back));
            normals[mesh.triangles[t][i]] += angle * of_triangle[t];
        }
    }
    for (Vec3& normal : normals) {
        const double length = normal.norm();
        normal = length > 1e-12 ? Vec3(normal / length) : Vec3::Zero();
    }
    return normals;
}

}  // namespace ossuary::mesh
