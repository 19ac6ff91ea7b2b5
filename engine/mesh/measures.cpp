#include "engine/mesh/measures.h"

#include <algorithm>

namespace ossuary::mesh {
namespace {

Vec3 area_vector(const TriangleMesh& mesh, std::size_t triangle) {
    const auto [a, b, c] = mesh.corners(triangle);
    return 0.5 * (b - a).cross(c - a);
}

Box3 bounds_of(const TriangleMesh& mesh, bool with_area) {
    Box3 bounds;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (with_area && is_degenerate(mesh, t)) continue;
        for (const std::uint32_t vertex : mesh.triangles[t]) bounds.extend(mesh.vertices[vertex]);
    }
    return bounds;
}

}  // namespace

double triangle_area(const TriangleMesh& mesh, std::size_t triangle) {
    return area_vector(mesh, triangle).norm();
}

std::vector<double> triangle_areas(const TriangleMesh& mesh) {
    std::vector<double> areas(mesh.triangles.size());
    for (std::size_t t = 0; t < areas.size(); ++t) areas[t] = triangle_area(mesh, t);
    return areas;
}

bool is_degenerate(const TriangleMesh& mesh, std::size_t triangle) {
    const TriangleMesh::Triangle& t = mesh.triangles[triangle];
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return true;
    // Copies of the corners and a list for the largest of three took half as long again.
    const Vec3& a = mesh.vertices[t[0]];
    const Vec3& b = mesh.vertices[t[1]];
    const Vec3& c = mesh.vertices[t[2]];
    const double longest =
        std::max(std::max((b - a).squaredNorm(), (c - b).squaredNorm()), (a - c).squaredNorm());
    return (b - a).cross(c - a).norm() <= 1e-12 * longest;
}

MeshMeasures measure(const TriangleMesh& mesh) {
    MeshMeasures measures;
    measures.bounds = bounds_of(mesh, true);
    if (measures.bounds.isEmpty()) measures.bounds = bounds_of(mesh, false);
    if (mesh.empty()) return measures;
    // Sums are taken about the centre of the box: far from the origin the volume would cancel out.
    const Vec3 center = measures.bounds.center();
    Vec3 moment = Vec3::Zero();
    double volume = 0.0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto corners = mesh.corners(t);
        const Vec3 a = corners[0] - center;
        const Vec3 b = corners[1] - center;
        const Vec3 c = corners[2] - center;
        const double area = 0.5 * (b - a).cross(c - a).norm();
        measures.surface_area += area;
        moment += area * (a + b + c);
        volume += a.dot(b.cross(c));
    }
    measures.signed_volume = volume / 6.0;
    measures.area_centroid = center;
    if (measures.surface_area > 0) measures.area_centroid += moment / (3.0 * measures.surface_area);
    measures.diagonal = measures.bounds.diagonal().norm();
    return measures;
}

}  // namespace ossuary::mesh
