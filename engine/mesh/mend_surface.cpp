#include "engine/mesh/mend_surface.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "engine/mesh/measures.h"
#include "engine/mesh/orient.h"
#include "engine/mesh/weld.h"

namespace ossuary::mesh {
namespace {

constexpr double kTolerance = 1e-5;  // of the size
constexpr double kSureTolerance = 1e-6;
constexpr double kEdgeShare = 0.25;

WeldOptions seam_options(const TriangleMesh& mesh) {
    const MeshMeasures measures = measure(mesh);
    WeldOptions options{.drop_collapsed = false};
    if (!(measures.diagonal > 0.0) || !std::isfinite(measures.diagonal)) return options;
    const double size = std::min(measures.diagonal, std::sqrt(measures.surface_area));
    options.tolerance = kTolerance * size / measures.diagonal;
    options.sure_tolerance = kSureTolerance * size / measures.diagonal;
    options.edge_share = kEdgeShare;
    return options;
}

bool names_a_vertex_twice(const TriangleMesh::Triangle& t) {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

std::uint64_t hash_of(const TriangleMesh::Triangle& sorted) {
    std::uint64_t hash = sorted[0];
    for (const std::uint32_t vertex : {sorted[1], sorted[2]}) {
        hash = (hash ^ (hash >> 29)) * 0x9E3779B97F4A7C15U + vertex;
    }
    return (hash ^ (hash >> 32)) * 0xBF58476D1CE4E5B9U;
}

/// For each triangle the first that has the same corners in any order; triangles that name a vertex
/// twice stand for themselves.
std::vector<std::uint32_t> first_of_its_corners(const TriangleMesh& mesh) {
    constexpr std::uint32_t kFree = 0xFFFFFFFFU;
    std::vector<std::uint32_t> table(std::bit_ceil(2 * mesh.triangles.size() + 1), kFree);
    std::vector<std::uint32_t> first(mesh.triangles.size());
    const auto sorted = [&](std::uint32_t t) {
        TriangleMesh::Triangle corners = mesh.triangles[t];
        std::sort(corners.begin(), corners.end());
        return corners;
    };
    for (std::uint32_t t = 0; t < first.size(); ++t) {
        first[t] = t;
        if (names_a_vertex_twice(mesh.triangles[t])) continue;
        const TriangleMesh::Triangle corners = sorted(t);
        std::size_t slot = (hash_of(corners) >> 7) & (table.size() - 1);
        while (table[slot] != kFree && sorted(table[slot]) != corners) {
            slot = (slot + 1) & (table.size() - 1);
        }
        if (table[slot] == kFree) table[slot] = t;
        first[t] = table[slot];
    }
    return first;
}

/// Leaves out the triangles that come again.
void drop_repeated(MendedSurface& surface) {
    const std::vector<std::uint32_t> first = first_of_its_corners(surface.mesh);
    TriangleMesh& mesh = surface.mesh;
    std::size_t kept = 0;
    surface.triangle_of.resize(first.size());
    for (std::uint32_t t = 0; t < first.size(); ++t) {
        if (first[t] != t) {
            surface.triangle_of[t] = surface.triangle_of[first[t]];
            continue;
        }
        surface.triangle_of[t] = static_cast<std::uint32_t>(kept);
        mesh.triangles[kept] = mesh.triangles[t];
        if (!mesh.face_of_triangle.empty()) {
            mesh.face_of_triangle[kept] = mesh.face_of_triangle[t];
        }
        if (!mesh.corner_colours.empty()) mesh.corner_colours[kept] = mesh.corner_colours[t];
        ++kept;
    }
    surface.repeated_triangles = first.size() - kept;
    mesh.triangles.resize(kept);
    if (!mesh.face_of_triangle.empty()) mesh.face_of_triangle.resize(kept);
    if (!mesh.corner_colours.empty()) mesh.corner_colours.resize(kept);
}

/// Lets each triangle begin at its first corner by position, and numbers the vertices as the
/// triangles come to them, so that neither says how the triangles came.
void begin_at_first_corners(MendedSurface& surface) {
    TriangleMesh& mesh = surface.mesh;
    const auto before = [&](std::uint32_t a, std::uint32_t b) {
        const Vec3 &p = mesh.vertices[a], &q = mesh.vertices[b];
        return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
    };
    std::vector<std::uint32_t> number(mesh.vertices.size(), MendedSurface::kUnused);
    std::vector<Vec3> vertices;
    vertices.reserve(mesh.vertices.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        TriangleMesh::Triangle& triangle = mesh.triangles[t];
        const auto first = std::min_element(triangle.begin(), triangle.end(), before);
        if (!mesh.corner_colours.empty()) {
            const CornerColours colours = mesh.corner_colours[t];
            const auto corner = static_cast<std::size_t>(first - triangle.begin());
            mesh.corner_colours[t] = {colours[corner], colours[(corner + 1) % 3],
                                      colours[(corner + 2) % 3]};
        }
        std::rotate(triangle.begin(), first, triangle.end());
        for (std::uint32_t& vertex : triangle) {
            if (number[vertex] == MendedSurface::kUnused) {
                number[vertex] = static_cast<std::uint32_t>(vertices.size());
                vertices.push_back(mesh.vertices[vertex]);
            }
            vertex = number[vertex];
        }
    }
    mesh.vertices = std::move(vertices);
    for (std::uint32_t& vertex : surface.vertex_of) {
        if (vertex != MendedSurface::kUnused) vertex = number[vertex];
    }
}

/// The boxes of the largest closed patches: what may be hollow.
std::vector<Box3> largest_closed(const std::vector<OrientedPatch>& patches) {
    constexpr std::size_t kMost = 32;
    std::vector<Box3> boxes;
    for (const OrientedPatch& patch : patches) {
        if (patch.closed) boxes.push_back(patch.bounds);
    }
    const std::size_t count = std::min(kMost, boxes.size());
    std::partial_sort(boxes.begin(), boxes.begin() + static_cast<std::ptrdiff_t>(count),
                      boxes.end(),
                      [](const Box3& a, const Box3& b) { return a.volume() > b.volume(); });
    boxes.resize(count);
    return boxes;
}

/// For each patch whether its triangles that lie the other way than they came are at fault, rather
/// than the others.
std::vector<bool> turned_are_at_fault(const std::vector<OrientedPatch>& patches) {
    const std::vector<Box3> hollow = largest_closed(patches);
    std::vector<bool> at_fault;
    at_fault.reserve(patches.size());
    for (const OrientedPatch& patch : patches) {
        const bool most_turned = 2 * patch.turned > patch.triangles;
        const bool inside =
            most_turned && patch.closed &&
            std::any_of(hollow.begin(), hollow.end(), [&](const Box3& box) {
                return box.contains(patch.bounds) && box.volume() > patch.bounds.volume();
            });
        at_fault.push_back(!most_turned || (patch.sure && !inside));
    }
    return at_fault;
}

/// Faces of the file, each once, that have a triangle at fault.
std::size_t count_faces_at_fault(const MendedSurface& surface) {
    const std::vector<bool> at_fault = turned_are_at_fault(surface.patches);
    const auto& face_of = surface.mesh.face_of_triangle;
    std::size_t count = 0;
    std::uint32_t last_face = MendedSurface::kUnused;
    for (std::size_t t = 0; t < surface.turned.size(); ++t) {
        if ((surface.turned[t] != 0) != at_fault[surface.patch_of[t]]) continue;
        if (!face_of.empty() && face_of[t] == last_face) continue;
        if (!face_of.empty()) last_face = face_of[t];
        ++count;
    }
    return count;
}

}  // namespace

MendedSurface mend_surface(const TriangleMesh& mesh) {
    MendedSurface surface;
    WeldResult welded = weld(mesh, seam_options(mesh));
    surface.mesh = std::move(welded.mesh);
    surface.vertex_of = std::move(welded.vertex_of);
    drop_repeated(surface);
    OrientResult oriented = orient(surface.mesh);
    surface.mesh = std::move(oriented.mesh);
    surface.turned = std::move(oriented.turned);
    surface.patches = std::move(oriented.patches);
    surface.patch_of = std::move(oriented.patch_of);
    begin_at_first_corners(surface);
    return surface;
}

void turn_over(MendedSurface& surface, const std::vector<bool>& chosen) {
    assert(chosen.size() == surface.patches.size());
    for (std::size_t t = 0; t < surface.patch_of.size(); ++t) {
        if (!chosen[surface.patch_of[t]]) continue;
        surface.mesh.turn_over(t);
        surface.turned[t] ^= 1;
    }
    for (std::size_t p = 0; p < chosen.size(); ++p) {
        OrientedPatch& patch = surface.patches[p];
        if (chosen[p]) patch.turned = patch.triangles - patch.turned;
    }
}

std::vector<MeshWarning> mending_warnings(const MendedSurface& surface) {
    std::vector<MeshWarning> warnings;
    const auto warn = [&](const char* code, std::size_t count, const char* what) {
        if (count == 0) return;
        warnings.push_back({code, count, std::to_string(count) + what});
    };
    warn("turned_faces", count_faces_at_fault(surface),
         " faces lie inside out; parts are found as if they did not");
    warn("repeated_triangles", surface.repeated_triangles, " triangles come more than once");
    return warnings;
}

}  // namespace ossuary::mesh
