#include "engine/mesh/weld.h"

#include <bit>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "engine/mesh/measures.h"

namespace ossuary::mesh {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

std::uint64_t mix(std::uint64_t hash, std::uint64_t value) {
    hash = (hash ^ value) * 0x9E3779B97F4A7C15u;
    return hash ^ (hash >> 29);
}

/// The smallest vertex index at each position, by open addressing.
std::vector<std::uint32_t> merge_equal(const std::vector<Vec3>& vertices) {
    std::vector<std::uint32_t> table(std::bit_ceil(2 * vertices.size() + 1), kNone);
    const std::size_t mask = table.size() - 1;
    std::vector<std::uint32_t> target(vertices.size());
    for (std::uint32_t v = 0; v < vertices.size(); ++v) {
        std::uint64_t hash = 0;
        // Adding zero makes -0 and 0 the same bits.
        for (const double x : vertices[v]) hash = mix(hash, std::bit_cast<std::uint64_t>(x + 0.0));
        std::size_t slot = (hash >> 7) & mask;
        while (table[slot] != kNone && vertices[table[slot]] != vertices[v]) {
            slot = (slot + 1) & mask;
        }
        if (table[slot] == kNone) table[slot] = v;
        target[v] = table[slot];
    }
    return target;
}

/// Each vertex goes to the first kept one within `distance`, else it is kept itself. The kept ones
/// lie in cells of that size, so that 27 cells hold all candidates.
std::vector<std::uint32_t> merge_near(const TriangleMesh& mesh, const Vec3& origin,
                                      double distance) {
    const std::vector<Vec3>& vertices = mesh.vertices;
    // Unused vertices may lie anywhere, also where cell numbers overflow.
    std::vector<std::uint8_t> used(vertices.size(), 0);
    for (const TriangleMesh::Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) used[vertex] = 1;
    }
    struct Hash {
        std::size_t operator()(const std::array<std::int64_t, 3>& cell) const {
            std::uint64_t hash = 0;
            for (const std::int64_t i : cell) hash = mix(hash, static_cast<std::uint64_t>(i));
            return hash;
        }
    };
    std::unordered_map<std::array<std::int64_t, 3>, std::vector<std::uint32_t>, Hash> cells;
    std::vector<std::uint32_t> target(vertices.size());
    for (std::uint32_t v = 0; v < vertices.size(); ++v) {
        target[v] = v;
        if (used[v] == 0) continue;
        std::array<std::int64_t, 3> cell{};
        for (int axis = 0; axis < 3; ++axis) {
            const double scaled = (vertices[v][axis] - origin[axis]) / distance;
            cell[static_cast<std::size_t>(axis)] = std::llround(std::floor(scaled));
        }
        std::uint32_t best = kNone;
        for (std::int64_t i = 0; i < 27; ++i) {
            const auto found =
                cells.find({cell[0] + i % 3 - 1, cell[1] + i / 3 % 3 - 1, cell[2] + i / 9 - 1});
            if (found == cells.end()) continue;
            for (const std::uint32_t kept : found->second) {
                if (kept < best && (vertices[kept] - vertices[v]).norm() <= distance) best = kept;
            }
        }
        if (best == kNone) {
            cells[cell].push_back(v);
        } else {
            target[v] = best;
        }
    }
    return target;
}

}  // namespace

WeldResult weld(const TriangleMesh& mesh, const WeldOptions& options) {
    const MeshMeasures measures = measure(mesh);
    // Below a part in 10^12 the cells would outgrow their integers; coordinates are no finer.
    const double tolerance = options.tolerance < 1e-12 ? 0.0 : options.tolerance;
    const double distance = tolerance * measures.diagonal;
    const std::vector<std::uint32_t> target =
        distance > 0 ? merge_near(mesh, measures.bounds.min(), distance)
                     : merge_equal(mesh.vertices);
    WeldResult result;
    for (std::uint32_t v = 0; v < target.size(); ++v) {
        result.merged_vertices += target[v] != v ? 1 : 0;
    }
    result.mesh.face_count = mesh.face_count;
    result.mesh.triangles.reserve(mesh.triangles.size());
    const bool mapped = mesh.face_of_triangle.size() == mesh.triangles.size();
    std::vector<std::uint32_t> renumbered(mesh.vertices.size(), kNone);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        TriangleMesh::Triangle triangle = mesh.triangles[t];
        for (std::uint32_t& vertex : triangle) vertex = target[vertex];
        if (options.drop_collapsed && (triangle[0] == triangle[1] || triangle[1] == triangle[2] ||
                                       triangle[2] == triangle[0])) {
            ++result.dropped_triangles;
            continue;
        }
        for (std::uint32_t& vertex : triangle) {
            if (renumbered[vertex] == kNone) {
                renumbered[vertex] = static_cast<std::uint32_t>(result.mesh.vertices.size());
                result.mesh.vertices.push_back(mesh.vertices[vertex]);
            }
            vertex = renumbered[vertex];
        }
        result.mesh.triangles.push_back(triangle);
        result.source_triangle.push_back(t);
        if (mapped) result.mesh.face_of_triangle.push_back(mesh.face_of_triangle[t]);
    }
    return result;
}

}  // namespace ossuary::mesh
