#include "engine/mesh/orient.h"

#include <utility>
#include <vector>

#include "engine/mesh/edge_table.h"

namespace ossuary::mesh {
namespace {

/// Whether the volume under the patch, seen from the mean of its corners, is negative by more than
/// rounding.
bool faces_inwards(const TriangleMesh& mesh, const std::vector<std::uint32_t>& patch) {
    Vec3 center = Vec3::Zero();
    for (const std::uint32_t t : patch) {
        for (const Vec3& corner : mesh.corners(t)) center += corner;
    }
    center /= 3.0 * static_cast<double>(patch.size());
    double volume = 0.0;
    double magnitude = 0.0;
    for (const std::uint32_t t : patch) {
        const auto [a, b, c] = mesh.corners(t);
        const double cone = (a - center).dot((b - center).cross(c - center));
        volume += cone;
        magnitude += (a - center).norm() * (b - center).cross(c - center).norm();
    }
    return volume < -1e-9 * magnitude;
}

}  // namespace

OrientResult orient(const TriangleMesh& mesh) {
    OrientResult result;
    result.mesh = mesh;
    const EdgeTable table = build_edge_table(mesh);
    const auto adjacent = adjacent_triangles(mesh, table);
    std::vector<std::uint8_t> turned(mesh.triangles.size(), 0);
    std::vector<std::uint8_t> seen(mesh.triangles.size(), 0);
    const auto agree = [&](std::uint32_t triangle, std::uint32_t side, std::uint32_t other) {
        std::uint32_t back = 0;
        const auto from = mesh.triangles[triangle][side];
        const auto to = mesh.triangles[triangle][(side + 1) % 3];
        while (mesh.triangles[other][back] != from) ++back;
        return mesh.triangles[other][(back + 2) % 3] == to;
    };
    std::vector<std::uint32_t> patch;
    for (std::uint32_t seed = 0; seed < mesh.triangles.size(); ++seed) {
        if (seen[seed] != 0) continue;
        patch.assign(1, seed);
        seen[seed] = 1;
        for (std::size_t head = 0; head < patch.size(); ++head) {
            const std::uint32_t t = patch[head];
            for (std::uint32_t side = 0; side < 3; ++side) {
                const std::uint32_t other = adjacent[t][side];
                if (other == kNoTriangle || seen[other] != 0) continue;
                seen[other] = 1;
                turned[other] = agree(t, side, other) ? turned[t] : turned[t] ^ 1;
                patch.push_back(other);
            }
        }
        for (const std::uint32_t t : patch) {
            if (turned[t] != 0) std::swap(result.mesh.triangles[t][1], result.mesh.triangles[t][2]);
        }
        if (faces_inwards(result.mesh, patch)) {
            for (const std::uint32_t t : patch) {
                std::swap(result.mesh.triangles[t][1], result.mesh.triangles[t][2]);
                turned[t] ^= 1;
            }
        }
        for (const std::uint32_t t : patch) result.flipped_triangles += turned[t];
    }
    for (const EdgeTable::Edge& edge : table.edges) {
        if (edge.side_count != 2) continue;
        const auto sides = table.sides_of(edge);
        const bool first = goes_up(mesh, sides[0]) != (turned[sides[0] / 3] != 0);
        const bool second = goes_up(mesh, sides[1]) != (turned[sides[1] / 3] != 0);
        if (first == second) ++result.unorientable_edges;
    }
    return result;
}

}  // namespace ossuary::mesh
