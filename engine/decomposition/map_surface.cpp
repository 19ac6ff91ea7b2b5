#include "engine/decomposition/map_surface.h"

#include <random>

#include "engine/decomposition/branch_mapping.h"
#include "engine/decomposition/flooding.h"
#include "engine/decomposition/vertex_graph.h"

namespace ossuary::decomposition {
namespace {

/// Whether each vertex is among the samples: selection sampling (Knuth, The Art of Computer
/// Programming, vol. 2, algorithm 3.4.2 S), so that the share is exact.
std::vector<bool> choose_samples(std::size_t count, const MapSurfaceOptions& options) {
    std::mt19937_64 random(options.seed);
    std::vector<bool> chosen(count, false);
    auto wanted = static_cast<std::size_t>(options.sampled * static_cast<double>(count) + 0.5);
    for (std::size_t v = 0; v < count && wanted > 0; ++v) {
        const double uniform = static_cast<double>(random() >> 11) * 0x1.0p-53;
        if (uniform * static_cast<double>(count - v) >= static_cast<double>(wanted)) continue;
        chosen[v] = true;
        --wanted;
    }
    return chosen;
}

std::uint32_t label_of(const mesh::TriangleMesh::Triangle& triangle,
                       const std::vector<std::uint32_t>& labels) {
    const std::uint32_t b = labels[triangle[1]], c = labels[triangle[2]];
    return b == c ? b : labels[triangle[0]];
}

}  // namespace

std::vector<std::uint32_t> map_surface(const mesh::TriangleMesh& mesh,
                                       const skeleton::SkeletonGraph& skeleton,
                                       const MapSurfaceOptions& options,
                                       const std::stop_token& stop) {
    if (skeleton.branches.empty()) return std::vector<std::uint32_t>(mesh.triangles.size(), 0);
    const VertexGraph surface = vertex_graph(mesh);
    const BranchMapping mapping(skeleton);
    const auto branch_of = [&](std::uint32_t v) {
        if (stop.stop_requested()) return std::uint32_t{0};
        return mapping.branch_of(mesh.vertices[v], surface.normals[v]);
    };
    std::vector<std::uint32_t> labels(surface.size(), kUnlabeled);
    const std::vector<bool> sampled = choose_samples(surface.size(), options);
    for (std::uint32_t v = 0; v < surface.size(); ++v) {
        if (sampled[v]) labels[v] = stop.stop_requested() ? 0 : branch_of(v);
    }
    flood_labels(surface, labels);
    // Pieces of the surface without a sample are small: all of their vertices are mapped.
    for (std::uint32_t v = 0; v < surface.size(); ++v) {
        if (labels[v] != kUnlabeled) continue;
        labels[v] = stop.stop_requested() ? 0 : branch_of(v);
    }
    refine_by_curvature(surface, labels);
    std::vector<std::uint32_t> of_triangle;
    of_triangle.reserve(mesh.triangles.size());
    for (const auto& triangle : mesh.triangles) of_triangle.push_back(label_of(triangle, labels));
    return of_triangle;
}

}  // namespace ossuary::decomposition
