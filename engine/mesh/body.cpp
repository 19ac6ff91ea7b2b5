#include "engine/mesh/body.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "engine/mesh/canonical_pose.h"
#include "engine/mesh/components.h"
#include "engine/mesh/faces_without_area.h"
#include "engine/mesh/measures.h"
#include "engine/mesh/nearby_groups.h"

namespace ossuary::mesh {
namespace {

using Triangles = std::vector<std::uint32_t>;

/// Looks for specks.
class SpeckFinder {
public:
    SpeckFinder(const TriangleMesh& mesh, const Mat3& axes, const BodyOptions& options,
                const std::stop_token& stop)
        : options_(options),
          stop_(stop),
          grouper_(mesh, axes, options.reach),
          areas_(triangle_areas(mesh)) {}

    /// The groups of triangles that are specks.
    std::vector<Triangles> find() {
        // Down to the main piece that holds together at its own scale: what lies beside it at each
        // scale on the way, and the piece.
        std::vector<std::vector<Triangles>> beside;
        Triangles core(areas_.size());
        std::iota(core.begin(), core.end(), 0u);
        for (;;) {
            std::vector<Triangles> groups = split(core);
            if (groups.size() < 2) break;
            const std::size_t main = largest(groups);
            core = std::move(groups[main]);
            groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(main));
            beside.push_back(std::move(groups));
        }
        core_side_ = side_of(core);
        core_area_ = area_of(core);
        std::vector<Triangles> specks;
        for (std::vector<Triangles>& groups : beside) {
            bool all_dust = true;
            for (Triangles& group : groups) {
                if (stop_.stop_requested()) return {};
                if (is_dust(group)) {
                    specks.push_back(std::move(group));
                } else {
                    all_dust = false;
                }
            }
            // Where something stays, so does the scale; else it is that of the main group.
            if (!all_dust) break;
        }
        return specks;
    }

    [[nodiscard]] double area_of(const Triangles& triangles) const {
        double area = 0.0;
        for (const std::uint32_t t : triangles) area += areas_[t];
        return area;
    }

private:
    [[nodiscard]] std::vector<Triangles> split(const Triangles& triangles) {
        const NearbyGroups groups = grouper_.group(triangles, stop_);
        std::vector<Triangles> members(groups.count);
        if (groups.count == 1) {
            members[0] = triangles;
            return members;
        }
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            members[groups.of[i]].push_back(triangles[i]);
        }
        return members;
    }

    [[nodiscard]] std::size_t largest(const std::vector<Triangles>& groups) const {
        std::vector<double> areas;
        for (const Triangles& group : groups) areas.push_back(area_of(group));
        return static_cast<std::size_t>(std::max_element(areas.begin(), areas.end()) -
                                        areas.begin());
    }

    [[nodiscard]] double side_of(const Triangles& triangles) const {
        return grouper_.box_of(triangles).sizes().maxCoeff();
    }

    /// Whether nothing in a group, taken apart as far as it falls apart at scales of its own, is as
    /// large as what counts. Specks may lie far from each other, too.
    [[nodiscard]] bool is_dust(const Triangles& group) {
        if (side_of(group) < options_.min_extent * core_side_) return true;
        const double least_area = options_.min_extent * options_.min_extent * core_area_;
        if (area_of(group) >= least_area) return false;
        const std::vector<Triangles> groups = split(group);
        return groups.size() > 1 && std::all_of(groups.begin(), groups.end(),
                                                [&](const Triangles& g) { return is_dust(g); });
    }

    const BodyOptions& options_;
    const std::stop_token& stop_;
    NearbyGrouper grouper_;
    std::vector<double> areas_;
    double core_side_ = 0.0;
    double core_area_ = 0.0;
};

TriangleMesh without_groups(const TriangleMesh& mesh, const std::vector<Triangles>& left_out) {
    std::vector<std::uint8_t> stays(mesh.triangles.size(), 1);
    for (const Triangles& group : left_out) {
        for (const std::uint32_t t : group) stays[t] = 0;
    }
    const bool mapped = mesh.face_of_triangle.size() == mesh.triangles.size();
    const bool coloured = !mesh.corner_colours.empty();
    TriangleMesh left;
    left.vertices = mesh.vertices;
    left.face_count = mesh.face_count;
    for (std::size_t t = 0; t < stays.size(); ++t) {
        if (stays[t] == 0) continue;
        left.triangles.push_back(mesh.triangles[t]);
        if (mapped) left.face_of_triangle.push_back(mesh.face_of_triangle[t]);
        if (coloured) left.corner_colours.push_back(mesh.corner_colours[t]);
    }
    return left;
}

Mat3 axes_of(const TriangleMesh& mesh, const BodyOptions& options) {
    return options.axes ? *options.axes : canonical_pose(mesh);
}

/// What is left out in one round has no part in the next.
void leave_out_specks(const TriangleMesh& whole, const BodyOptions& options,
                      const std::stop_token& stop, Body& body) {
    constexpr int kMaxRounds = 20;
    double left_out = 0.0;
    for (int round = 0; round < kMaxRounds; ++round) {
        const TriangleMesh& mesh = body.of(whole);
        SpeckFinder finder(mesh, body.axes, options, stop);
        const std::vector<Triangles> specks = finder.find();
        if (specks.empty() || stop.stop_requested()) return;
        for (const Triangles& speck : specks) left_out += finder.area_of(speck);
        if (left_out > options.max_area * measure(whole).surface_area) return;
        for (const Triangles& speck : specks) body.triangles_apart += speck.size();
        body.pieces_apart += specks.size();
        body.mesh = without_groups(mesh, specks);
        body.axes = axes_of(*body.mesh, options);
    }
}

bool has_finite_vertices(const TriangleMesh& mesh) {
    return std::all_of(mesh.vertices.begin(), mesh.vertices.end(),
                       [](const Vec3& v) { return v.allFinite(); });
}

}  // namespace

Body find_body(const TriangleMesh& mesh, const BodyOptions& options, const std::stop_token& stop) {
    Body body;
    if (!has_finite_vertices(mesh)) {  // for others to refuse
        if (options.axes) body.axes = *options.axes;
        return body;
    }
    WithoutEmptyFaces filled = without_empty_faces(mesh);
    body.mesh = std::move(filled.mesh);
    body.faces_without_area = filled.removed;
    body.axes = axes_of(body.of(mesh), options);
    if (options.min_extent > 0 && connected_components(body.of(mesh)).count > 1) {
        leave_out_specks(mesh, options, stop, body);
    }
    return body;
}

}  // namespace ossuary::mesh
