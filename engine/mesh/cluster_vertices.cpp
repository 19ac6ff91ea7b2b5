#include "engine/mesh/cluster_vertices.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/mesh/measures.h"

namespace ossuary {
namespace {

struct Clusters {
    std::vector<std::uint32_t> of_vertex;
    std::uint32_t count = 0;
};

/// Numbers the occupied cells in the order of their position.
Clusters assign_cells(const TriangleMesh& mesh, const Box3& bounds, int cells_along) {
    const double scale = cells_along / bounds.sizes().maxCoeff();
    std::vector<std::uint64_t> cell(mesh.vertices.size());
    for (std::size_t v = 0; v < cell.size(); ++v) {
        for (int axis = 0; axis < 3; ++axis) {
            const double at = std::floor((mesh.vertices[v][axis] - bounds.min()[axis]) * scale);
            const double inside = std::clamp(at, 0.0, static_cast<double>(cells_along - 1));
            cell[v] = cell[v] * 1024 + static_cast<std::uint64_t>(inside);
        }
    }
    std::vector<std::uint64_t> occupied = cell;
    std::sort(occupied.begin(), occupied.end());
    occupied.erase(std::unique(occupied.begin(), occupied.end()), occupied.end());
    Clusters clusters;
    clusters.count = static_cast<std::uint32_t>(occupied.size());
    clusters.of_vertex.reserve(cell.size());
    for (const std::uint64_t key : cell) {
        const auto found = std::lower_bound(occupied.begin(), occupied.end(), key);
        clusters.of_vertex.push_back(static_cast<std::uint32_t>(found - occupied.begin()));
    }
    return clusters;
}

/// The triangles that survive, each once whatever its orientation, in the order of the input.
std::vector<TriangleMesh::Triangle> surviving_triangles(const TriangleMesh& mesh,
                                                        const Clusters& clusters) {
    struct Candidate {
        TriangleMesh::Triangle sorted;
        TriangleMesh::Triangle triangle;
        std::uint32_t order;
    };
    std::vector<Candidate> candidates;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        TriangleMesh::Triangle triangle = mesh.triangles[t];
        for (std::uint32_t& vertex : triangle) vertex = clusters.of_vertex[vertex];
        TriangleMesh::Triangle sorted = triangle;
        std::sort(sorted.begin(), sorted.end());
        if (sorted[0] == sorted[1] || sorted[1] == sorted[2]) continue;
        candidates.push_back({sorted, triangle, t});
    }
    std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
        return a.sorted != b.sorted ? a.sorted < b.sorted : a.order < b.order;
    });
    candidates.erase(
        std::unique(candidates.begin(), candidates.end(),
                    [](const Candidate& a, const Candidate& b) { return a.sorted == b.sorted; }),
        candidates.end());
    std::sort(candidates.begin(), candidates.end(),
              [](const Candidate& a, const Candidate& b) { return a.order < b.order; });
    std::vector<TriangleMesh::Triangle> triangles;
    triangles.reserve(candidates.size());
    for (const Candidate& candidate : candidates) triangles.push_back(candidate.triangle);
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
    int fits = 0;  // cells along the longest side
    int too_fine = 1025;
    while (too_fine - fits > 1) {
        const int cells = (fits + too_fine) / 2;
        const Clusters clusters = assign_cells(mesh, measures.bounds, cells);
        (surviving_triangles(mesh, clusters).size() <= max_triangles ? fits : too_fine) = cells;
    }
    if (fits == 0) return coarse;
    const Clusters clusters = assign_cells(mesh, measures.bounds, fits);
    coarse.triangles = surviving_triangles(mesh, clusters);
    coarse.vertices = representatives(mesh, clusters);
    coarse.face_count = static_cast<std::uint32_t>(coarse.triangles.size());
    coarse.face_of_triangle.resize(coarse.triangles.size());
    std::iota(coarse.face_of_triangle.begin(), coarse.face_of_triangle.end(), 0u);
    return coarse;
}

}  // namespace ossuary
