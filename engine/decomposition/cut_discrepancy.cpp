#include "engine/decomposition/cut_discrepancy.h"

#include <cassert>
#include <cmath>

#include "engine/mesh/measures.h"

namespace ossuary::decomposition {
namespace {

/// The mean distance of the surface from its centre of gravity, triangle by triangle.
double average_radius(const mesh::TriangleMesh& mesh) {
    const Vec3 center = mesh::measure(mesh).area_centroid;
    double sum = 0.0, area_sum = 0.0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto [a, b, c] = mesh.corners(t);
        const double area = mesh::triangle_area(mesh, t);
        sum += area * ((a + b + c) / 3.0 - center).norm();
        area_sum += area;
    }
    return area_sum > 0.0 ? sum / area_sum : 0.0;
}

}  // namespace

CutDiscrepancy::CutDiscrepancy(const mesh::TriangleMesh& mesh)
    : edges_(mesh::build_edge_table(mesh)),
      graph_(mesh, {.cross_edges = false}),
      vertex_count_(mesh.vertices.size()),
      average_radius_(average_radius(mesh)) {}

CutDiscrepancy::Cuts CutDiscrepancy::cuts_of(const Segmentation& segmentation) const {
    std::vector<bool> on_cut(vertex_count_, false);
    for (const mesh::EdgeTable::Edge& edge : edges_.edges) {
        const auto sides = edges_.sides_of(edge);
        if (sides.size() < 2) continue;
        const std::uint32_t label = segmentation.labels[sides[0] / 3];
        for (const std::uint32_t side : sides) {
            if (segmentation.labels[side / 3] != label) on_cut[edge.a] = on_cut[edge.b] = true;
        }
    }
    Cuts cuts;
    for (std::uint32_t v = 0; v < on_cut.size(); ++v) {
        if (on_cut[v]) cuts.vertices.push_back(v);
    }
    if (!cuts.vertices.empty()) cuts.distances = graph_.distances_from(cuts.vertices);
    return cuts;
}

std::optional<double> CutDiscrepancy::operator()(const Cuts& a, const Cuts& b) const {
    if (a.vertices.empty() && b.vertices.empty()) return 0.0;
    if (a.vertices.empty() || b.vertices.empty() || average_radius_ <= 0.0) return std::nullopt;
    double sum = 0.0;
    std::size_t count = 0;
    const auto add = [&](const Cuts& from, const Cuts& to) {
        for (const std::uint32_t v : from.vertices) {
            if (!std::isfinite(to.distances[v])) continue;  // no cut on this piece of the surface
            sum += to.distances[v];
            ++count;
        }
    };
    add(a, b);
    add(b, a);
    if (count == 0) return std::nullopt;
    return sum / static_cast<double>(count) / average_radius_;
}

}  // namespace ossuary::decomposition
