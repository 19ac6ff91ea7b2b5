#include "engine/mesh/geodesics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/core/shortest_ways.h"
#include "engine/mesh/edge_table.h"

namespace ossuary::mesh {
namespace {

struct Arc {
    std::uint32_t a;
    std::uint32_t b;
    double length;
};

std::uint32_t opposite_vertex(const TriangleMesh& mesh, std::uint32_t side) {
    return mesh.triangles[side / 3][(side % 3 + 2) % 3];
}

/// The straight way between the corners c and d on both sides of the edge a b, if it crosses the
/// edge once both triangles lie in one plane.
std::optional<double> across(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const double base = (b - a).norm();
    if (!(base > 0)) return std::nullopt;
    const Vec3 along = (b - a) / base;
    const double xc = (c - a).dot(along);
    const double xd = (d - a).dot(along);
    const double yc = (c - a - xc * along).norm();
    const double yd = (d - a - xd * along).norm();
    if (!(yc + yd > 0)) return std::nullopt;
    const double crossing = xc + (xd - xc) * yc / (yc + yd);
    if (!(crossing > 0 && crossing < base)) return std::nullopt;
    return std::hypot(xd - xc, yc + yd);
}

}  // namespace

GeodesicGraph::GeodesicGraph(const TriangleMesh& mesh, const GeodesicOptions& options) {
    const EdgeTable table = build_edge_table(mesh);
    std::vector<Arc> arcs;
    arcs.reserve(2 * table.edges.size());
    for (const EdgeTable::Edge& edge : table.edges) {
        const Vec3& a = mesh.vertices[edge.a];
        const Vec3& b = mesh.vertices[edge.b];
        arcs.push_back({edge.a, edge.b, (b - a).norm()});
        if (!options.cross_edges || edge.side_count != 2) continue;
        const auto sides = table.sides_of(edge);
        const std::uint32_t c = opposite_vertex(mesh, sides[0]);
        const std::uint32_t d = opposite_vertex(mesh, sides[1]);
        if (c == d) continue;
        if (const auto length = across(a, b, mesh.vertices[c], mesh.vertices[d])) {
            arcs.push_back({c, d, *length});
        }
    }
    first_.assign(mesh.vertices.size() + 1, 0);
    for (const Arc& arc : arcs) {
        ++first_[arc.a + 1];
        ++first_[arc.b + 1];
    }
    for (std::size_t v = 0; v + 1 < first_.size(); ++v) first_[v + 1] += first_[v];
    links_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (const Arc& arc : arcs) {
        links_[next[arc.a]++] = {arc.b, arc.length};
        links_[next[arc.b]++] = {arc.a, arc.length};
    }
}

std::vector<double> GeodesicGraph::distances_from(std::span<const std::uint32_t> sources) const {
    std::vector<double> distance(vertex_count(), std::numeric_limits<double>::infinity());
    for (const std::uint32_t source : sources) {
        assert(source < vertex_count());
        distance[source] = 0.0;
    }
    ShortestWays<double>().search(distance, sources, [&](std::uint32_t from, const auto& reach) {
        for (std::uint32_t i = first_[from]; i < first_[from + 1]; ++i) {
            reach(links_[i].to, distance[from] + links_[i].length);
        }
    });
    return distance;
}

}  // namespace ossuary::mesh
