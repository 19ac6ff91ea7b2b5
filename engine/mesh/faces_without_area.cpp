#include "engine/mesh/faces_without_area.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "engine/mesh/disjoint_sets.h"
#include "engine/mesh/edge_table.h"
#include "engine/mesh/measures.h"
#include "engine/mesh/weld.h"

namespace ossuary::mesh {
namespace {

constexpr std::uint32_t kNowhere = std::numeric_limits<std::uint32_t>::max();

/// What is left when empty triangles with an edge that no other triangle has are taken away, again
/// and again: those hang on a surface or lie apart, and close nothing.
std::vector<std::uint8_t> peel_hanging(const TriangleMesh& mesh,
                                       const std::vector<std::uint8_t>& area) {
    std::vector<std::uint8_t> kept(area.size(), 1);
    const EdgeTable table = build_edge_table(mesh);
    std::vector<std::uint32_t> edge_of_side(3 * mesh.triangles.size(), kNowhere);
    std::vector<std::uint32_t> count;
    count.reserve(table.edges.size());
    for (const EdgeTable::Edge& edge : table.edges) {
        for (const std::uint32_t side : table.sides_of(edge)) {
            edge_of_side[side] = static_cast<std::uint32_t>(count.size());
        }
        count.push_back(edge.side_count);
    }
    const auto hangs = [&](std::uint32_t t) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t edge = edge_of_side[3 * t + k];
            if (edge == kNowhere || count[edge] < 2) return true;  // none: names a vertex twice
        }
        return false;
    };
    std::vector<std::uint32_t> waiting;
    for (std::uint32_t t = 0; t < area.size(); ++t) {
        if (area[t] == 0) waiting.push_back(t);
    }
    while (!waiting.empty()) {
        const std::uint32_t t = waiting.back();
        waiting.pop_back();
        if (kept[t] == 0 || !hangs(t)) continue;
        kept[t] = 0;
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t edge = edge_of_side[3 * t + k];
            if (edge == kNowhere) continue;
            --count[edge];
            for (const std::uint32_t side : table.sides_of(table.edges[edge])) {
                if (area[side / 3] == 0) waiting.push_back(side / 3);
            }
        }
    }
    return kept;
}

/// For each place that only empty triangles use, a vertex of the input to which it is drawn: one at
/// a place with area that they hold on to, the first; kNowhere where there is none.
struct Anchors {
    std::vector<std::uint8_t> held;      ///< places that triangles with area use
    std::vector<std::uint32_t> targets;  ///< by place
};

Anchors find_anchors(const TriangleMesh& mesh, const TriangleMesh& welded,
                     const std::vector<std::uint8_t>& area, const std::vector<std::uint8_t>& kept) {
    Anchors anchors;
    anchors.held.assign(welded.vertices.size(), 0);
    for (std::size_t t = 0; t < area.size(); ++t) {
        if (area[t] == 0) continue;
        for (const std::uint32_t place : welded.triangles[t]) anchors.held[place] = 1;
    }
    DisjointSets loose(welded.vertices.size());
    const auto for_each_kept = [&](auto&& visit) {
        for (std::size_t t = 0; t < area.size(); ++t) {
            if (area[t] == 0 && kept[t] != 0) visit(t);
        }
    };
    for_each_kept([&](std::size_t t) {
        const TriangleMesh::Triangle& places = welded.triangles[t];
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = places[k], b = places[(k + 1) % 3];
            if (anchors.held[a] == 0 && anchors.held[b] == 0) loose.unite(a, b);
        }
    });
    anchors.targets.assign(welded.vertices.size(), kNowhere);
    for_each_kept([&](std::size_t t) {
        const TriangleMesh::Triangle& places = welded.triangles[t];
        for (std::size_t k = 0; k < 3; ++k) {
            if (anchors.held[places[k]] == 0) continue;
            for (const std::uint32_t other : places) {
                if (anchors.held[other] != 0) continue;
                std::uint32_t& target = anchors.targets[loose.find(other)];
                target = std::min(target, mesh.triangles[t][k]);
            }
        }
    });
    for (std::uint32_t place = 0; place < anchors.targets.size(); ++place) {
        anchors.targets[place] = anchors.targets[loose.find(place)];
    }
    return anchors;
}

/// Whether two corners lie at one place.
bool is_collapsed(const std::vector<Vec3>& vertices, const TriangleMesh::Triangle& t) {
    const Vec3 &a = vertices[t[0]], &b = vertices[t[1]], &c = vertices[t[2]];
    return a == b || b == c || c == a;
}

}  // namespace

std::vector<std::uint8_t> have_area(const TriangleMesh& mesh) {
    std::vector<std::uint8_t> area(mesh.triangles.size());
    for (std::size_t t = 0; t < area.size(); ++t) area[t] = is_degenerate(mesh, t) ? 0 : 1;
    return area;
}

WithoutEmptyFaces without_empty_faces(const TriangleMesh& mesh) {
    WithoutEmptyFaces result;
    const std::vector<std::uint8_t> area = have_area(mesh);
    const auto with_area = std::count(area.begin(), area.end(), std::uint8_t{1});
    if (with_area == 0 || with_area == std::ssize(area)) return result;

    const TriangleMesh welded = weld(mesh, {.tolerance = 0.0, .drop_collapsed = false}).mesh;
    // Some surfaces are closed as they are numbered, others where vertices at one place are one.
    std::vector<std::uint8_t> kept = peel_hanging(mesh, area);
    const std::vector<std::uint8_t> kept_welded = peel_hanging(welded, area);
    for (std::size_t t = 0; t < kept.size(); ++t) kept[t] = std::max(kept[t], kept_welded[t]);
    const Anchors anchors = find_anchors(mesh, welded, area, kept);

    const bool mapped = mesh.face_of_triangle.size() == mesh.triangles.size();
    const bool coloured = !mesh.corner_colours.empty();
    TriangleMesh left;
    left.face_count = mesh.face_count;
    bool any_drawn = false;
    for (std::size_t t = 0; t < area.size(); ++t) {
        TriangleMesh::Triangle triangle = mesh.triangles[t];
        if (area[t] == 0) {
            bool stays = kept[t] != 0;
            bool drawn = false;
            for (std::size_t k = 0; k < 3 && stays; ++k) {
                const std::uint32_t place = welded.triangles[t][k];
                if (anchors.held[place] != 0) continue;
                triangle[k] = anchors.targets[place];
                stays = triangle[k] != kNowhere;
                drawn = true;
            }
            // Corners that are drawn together leave nothing, not even a line.
            if (!stays || (drawn && is_collapsed(mesh.vertices, triangle))) {
                ++result.removed;
                continue;
            }
            any_drawn = any_drawn || drawn;
        }
        left.triangles.push_back(triangle);
        if (mapped) left.face_of_triangle.push_back(mesh.face_of_triangle[t]);
        if (coloured) left.corner_colours.push_back(mesh.corner_colours[t]);
    }
    if (result.removed == 0 && !any_drawn) return result;
    left.vertices = mesh.vertices;
    result.mesh = std::move(left);
    return result;
}

}  // namespace ossuary::mesh
