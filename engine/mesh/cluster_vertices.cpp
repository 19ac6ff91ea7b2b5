#include "engine/mesh/cluster_vertices.h"

#include <algorithm>
#include <array>
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

/// Which cluster a cell has, as the vertices come to the cells: an array where the grid is small
/// against the mesh, else a hash table.
class OccupiedCells {
public:
    OccupiedCells(std::size_t vertices, int cells_along) : cells_along_(cells_along) {
        const auto side = static_cast<std::uint64_t>(cells_along);
        direct_ = side * side * side <= 4 * vertices;
        if (direct_) {
            clusters_.assign(side * side * side, kFree);
        } else {
            slots_.resize(std::bit_ceil(2 * vertices + 1));
        }
    }

    /// The cluster of this cell; `next`, which is then its own, where it has none yet.
    std::uint32_t cluster_of(const std::array<std::uint32_t, 3>& cell, std::uint32_t next) {
        const auto side = static_cast<std::uint32_t>(cells_along_);
        const std::uint32_t number = (cell[0] * side + cell[1]) * side + cell[2];
        if (direct_) {
            std::uint32_t& cluster = clusters_[number];
            if (cluster == kFree) cluster = next;
            return cluster;
        }
        std::size_t slot = slot_of(number, slots_.size());
        while (slots_[slot].cluster != kFree && slots_[slot].cell != number) {
            slot = (slot + 1) & (slots_.size() - 1);
        }
        if (slots_[slot].cluster == kFree) slots_[slot] = {number, next};
        return slots_[slot].cluster;
    }

private:
    struct Slot {
        std::uint32_t cell = 0;
        std::uint32_t cluster = kFree;
    };

    int cells_along_;
    bool direct_ = false;
    std::vector<std::uint32_t> clusters_;
    std::vector<Slot> slots_;
};

/// Numbers the occupied cells as the vertices come to them.
Clusters assign_cells(const TriangleMesh& mesh, const Box3& bounds, int cells_along) {
    const double scale = cells_along / bounds.sizes().maxCoeff();
    OccupiedCells occupied(mesh.vertices.size(), cells_along);
    Clusters clusters;
    clusters.of_vertex.reserve(mesh.vertices.size());
    for (const Vec3& vertex : mesh.vertices) {
        std::array<std::uint32_t, 3> cell{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto i = static_cast<Eigen::Index>(axis);
            const double at = (vertex[i] - bounds.min()[i]) * scale;
            const double inside = std::clamp(at, 0.0, static_cast<double>(cells_along - 1));
            cell[axis] = static_cast<std::uint32_t>(inside);
        }
        const std::uint32_t cluster = occupied.cluster_of(cell, clusters.count);
        if (cluster == clusters.count) ++clusters.count;
        clusters.of_vertex.push_back(cluster);
    }
    return clusters;
}

struct Survivors {
    /// Each once whatever its orientation, in the order of the input; one too many, where there are
    /// more than were asked for.
    std::vector<TriangleMesh::Triangle> triangles;
    std::vector<std::uint32_t> sources;  ///< of each, in the input
    double estimate = 0;  ///< how many there are in all, by the share of the mesh that was read
};

/// The triangles that survive, read until there are more than `most`.
Survivors surviving_triangles(const TriangleMesh& mesh, const Clusters& clusters,
                              std::size_t most) {
    Survivors survivors;
    std::vector<TriangleMesh::Triangle> sorted;
    const std::size_t room = std::min(mesh.triangles.size(), most + 1);
    std::vector<std::uint32_t> table(std::bit_ceil(2 * room + 1), kFree);
    std::size_t seen = 0;
    for (TriangleMesh::Triangle triangle : mesh.triangles) {
        if (survivors.triangles.size() > most) break;
        const auto source = static_cast<std::uint32_t>(seen++);
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
        table[slot] = static_cast<std::uint32_t>(survivors.triangles.size());
        survivors.triangles.push_back(triangle);
        survivors.sources.push_back(source);
        sorted.push_back(key);
    }
    survivors.estimate = static_cast<double>(survivors.triangles.size()) *
                         static_cast<double>(mesh.triangles.size()) / static_cast<double>(seen);
    return survivors;
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
    Clusters best;
    std::vector<std::uint32_t> sources;
    while (too_fine - fits > 1) {
        const double inside = std::clamp(guess, fits + 1.0, too_fine - 1.0);
        const int cells = static_cast<int>(inside);
        Clusters clusters = assign_cells(mesh, measures.bounds, cells);
        Survivors survivors = surviving_triangles(mesh, clusters, max_triangles);
        guess = cells * std::sqrt(wanted / std::max(1.0, survivors.estimate));
        if (survivors.triangles.size() > max_triangles) {
            too_fine = cells;
            continue;
        }
        fits = cells;
        coarse.triangles = std::move(survivors.triangles);
        sources = std::move(survivors.sources);
        best = std::move(clusters);
        const auto count = static_cast<double>(coarse.triangles.size());
        if (count > 0.93 * static_cast<double>(max_triangles)) break;
    }
    coarse.vertices = representatives(mesh, best);
    coarse.face_count = static_cast<std::uint32_t>(coarse.triangles.size());
    coarse.face_of_triangle.resize(coarse.triangles.size());
    std::iota(coarse.face_of_triangle.begin(), coarse.face_of_triangle.end(), 0u);
    if (!mesh.corner_colours.empty()) {
        for (const std::uint32_t source : sources) {
            coarse.corner_colours.push_back(mesh.corner_colours[source]);
        }
    }
    return coarse;
}

}  // namespace ossuary::mesh
