#include "engine/mesh/cluster_vertices.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "engine/mesh/measures.h"

namespace ossuary::mesh {
namespace {

constexpr std::uint32_t kFree = 0xFFFFFFFFu;
constexpr int kFinest = 1024;

std::size_t slot_of(std::uint64_t key, std::size_t slots) {
    key *= 0x9E3779B97F4A7C15u;
    return (key ^ (key >> 32)) & (slots - 1);
}

struct Clusters {
    std::vector<std::uint32_t> of_vertex;
    std::uint32_t count = 0;
};

/// Numbers the occupied cells as the vertices come to them.
Clusters assign_cells(const TriangleMesh& mesh, const Box3& bounds, int cells_along) {
    const double scale = cells_along / bounds.sizes().maxCoeff();
    struct Slot {
        std::uint32_t cell = 0;
        std::uint32_t cluster = kFree;
    };
    std::vector<Slot> table(std::bit_ceil(2 * mesh.vertices.size() + 1));
    Clusters clusters;
    clusters.of_vertex.reserve(mesh.vertices.size());
    for (const Vec3& vertex : mesh.vertices) {
        std::uint32_t cell = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const double at = (vertex[axis] - bounds.min()[axis]) * scale;
            const double inside = std::clamp(at, 0.0, static_cast<double>(cells_along - 1));
            cell = cell * kFinest + static_cast<std::uint32_t>(inside);
        }
        std::size_t slot = slot_of(cell, table.size());
        while (table[slot].cluster != kFree && table[slot].cell != cell) {
            slot = (slot + 1) & (table.size() - 1);
        }
        if (table[slot].cluster == kFree) table[slot] = {cell, clusters.count++};
        clusters.of_vertex.push_back(table[slot].cluster);
    }
    return clusters;
}

/// The triangles that survive, each once whatever its orientation, in the order of the input.
std::vector<TriangleMesh::Triangle> surviving_triangles(const TriangleMesh& mesh,
                                                        const Clusters& clusters) {
    std::vector<TriangleMesh::Triangle> triangles;
    std::vector<TriangleMesh::Triangle> sorted;
    std::vector<std::uint32_t> table(std::bit_ceil(2 * mesh.triangles.size() + 1), kFree);
    for (TriangleMesh::Triangle triangle : mesh.triangles) {
        for (std::uint32_t& vertex : triangle) vertex = clusters.of_vertex[vertex];
        TriangleMesh::Triangle key = triangle;
        if (key[0] > key[1]) std::swap(key[0], key[1]);
        if (key[1] > key[2]) std::swap(key[1], key[2]);
        if (key[0] > key[1]) std::swap(key[0], key[1]);
        if (key[0] == key[1] || key[1] == key[2]) continue;
        const std::uint64_t hash =
            (key[0] * std::uint64_t{0x9E3779B1} + key[1]) * std::uint64_t{0x85EBCA77C2B2AE63} +
            key[2];
        std::size_t slot = slot_of(hash, table.size());
        while (table[slot] != kFree && sorted[table[slot]] != key) {
            slot = (slot + 1) & (table.size() - 1);
        }
        if (table[slot] != kFree) continue;
        table[slot] = static_cast<std::uint32_t>(triangles.size());
        triangles.push_back(triangle);
        sorted.push_back(key);
    }
    return triangles;
}

std::vector<Vec3> representatives(const TriangleMesh& mesh, const Clusters& clusters) {
    std::vector<double> weight_of_vertex(mesh.vertices.size(), 0.0);
    const std::vector<double> areas = triangle_areas(mesh);
    const double least = 1e-9 * std::accumulate(areas.begin(), areas.end(), 0.0) + 1e-300;
    for (std::size_t t = 0; t < areas.size(); ++t) {
        for (const std::uint32_t v : mesh.triangles[t]) weight_of_vertex[v] += areas[t] + least;
    }
    std::vector<Vec3> sums(clusters.count, Vec3::Zero());
    std::vector<double> weights(clusters.count, 0.0);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        sums[clusters.of_vertex[v]] += weight_of_vertex[v] * mesh.vertices[v];
        weights[clusters.of_vertex[v]] += weight_of_vertex[v];
    }
    for (std::size_t c = 0; c < sums.size(); ++c) {
        if (weights[c] > 0) sums[c] /= weights[c];
    }
    return sums;
}

}  // namespace

TriangleMesh cluster_vertices(const TriangleMesh& mesh, std::size_t max_triangles) {
    TriangleMesh coarse;
    const MeshMeasures measures = measure(mesh);
    if (mesh.empty() || !(measures.bounds.sizes().maxCoeff() > 0)) return coarse;
    // The number of triangles grows with the square of the cells along a side, which makes each
    // guess a good one: two or three grids are tried, where halving the interval took ten.
    const double side = measures.bounds.sizes().maxCoeff();
    const double wanted = 0.97 * static_cast<double>(max_triangles);
    double guess = side * std::sqrt(wanted / (2.0 * measures.surface_area + 1e-300));
    int fits = 0;
    int too_fine = kFinest + 1;
    while (too_fine - fits > 1) {
        const double inside = std::clamp(guess, fits + 1.0, too_fine - 1.0);
        const int cells = static_cast<int>(inside);
        const Clusters clusters = assign_cells(mesh, measures.bounds, cells);
        std::vector<TriangleMesh::Triangle> triangles = surviving_triangles(mesh, clusters);
        const auto count = static_cast<double>(triangles.size());
        guess = cells * std::sqrt(wanted / std::max(1.0, count));
        if (triangles.size() > max_triangles) {
            too_fine = cells;
            continue;
        }
        fits = cells;
        coarse.triangles = std::move(triangles);
        coarse.vertices = representatives(mesh, clusters);
        if (count > 0.93 * static_cast<double>(max_triangles)) break;
    }
    coarse.face_count = static_cast<std::uint32_t>(coarse.triangles.size());
    coarse.face_of_triangle.resize(coarse.triangles.size());
    std::iota(coarse.face_of_triangle.begin(), coarse.face_of_triangle.end(), 0u);
    return coarse;
}

}  // namespace ossuary::mesh
