#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/voxel/bit_volume.h"
#include "engine/voxel/cast_meter.h"
#include "engine/voxel/grid_mesh.h"
#include "engine/voxel/line_projection.h"
#include "engine/voxel/ray_columns.h"

namespace ossuary::voxel {

/// Finds the places where lines cross triangles; ray_columns.h says what counts as one. Small
/// triangles, most of a fine mesh, go through in stages, so that what a branch would have to guess
/// (is there a line, does it cross) becomes how far a list has grown: a third of the time of
/// triangle after triangle.
class CrossingFinder {
public:
    CrossingFinder(const GridMesh& mesh, const LineDirection& direction, CastMeter& meter)
        : mesh_(mesh), project_(direction), only_(direction.only), meter_(meter) {}

    /// Calls visit(u, v, depth, triangle, entering) for each crossing; ends early where the meter
    /// says so.
    template <typename Visit>
    void find(std::span<const std::uint32_t> triangles, Visit&& visit) {
        meter_.begin_cast();
        // A few triangles work theirs out as they come.
        if (triangles.size() > mesh_.points.size() / 2) bound_points();
        while (!triangles.empty()) {
            const std::size_t count = std::min(triangles.size(), kChunk);
            const std::size_t boxes = take_boxes(triangles.first(count));
            triangles = triangles.subspan(count);
            std::size_t lines = 0;
            for (std::size_t i = 0; i < boxes; ++i) {
                const Boxed& boxed = boxes_[i];
                if (only_ != nullptr && !meets_only(boxed)) continue;
                if (boxed.width() <= 2 && boxed.height() <= 2) {
                    lines = list_lines(boxed, lines);
                } else if (!visit_rows(boxed, visit)) {
                    return;
                }
            }
            std::size_t crossed = 0;
            for (std::size_t i = 0; i < lines; ++i) {
                const Line line = lines_[i];
                lines_[crossed] = line;
                crossed += place_of(line, corners(line.triangle)).crosses() ? 1 : 0;
            }
            if (!meter_.count(count, crossed)) return;
            for (std::size_t i = 0; i < crossed; ++i) {
                const Line& line = lines_[i];
                if (only_ != nullptr && !only_->test(line.u, line.v, 0)) continue;
                const LineCorners p = corners(line.triangle);
                const LinePlace place = place_of(line, p);
                visit(line.u, line.v, place.depth(p), line.triangle, place.enters());
            }
        }
    }

private:
    static constexpr std::size_t kChunk = 256;  ///< the lists stay in the nearest cache

    /// First line along u, last negated, the same along v: the bounds of several points are their
    /// least ones, number by number.
    using Bounds __attribute__((vector_size(8))) = std::int16_t;

    struct Boxed {
        Bounds bounds;
        std::uint32_t triangle;
        [[nodiscard]] int width() const { return 1 - bounds[1] - bounds[0]; }
        [[nodiscard]] int height() const { return 1 - bounds[3] - bounds[2]; }
    };
    struct Line {
        std::uint32_t triangle;
        std::int32_t u, v;
    };

    [[nodiscard]] LineCorners corners(std::uint32_t t) const {
        const GridMesh::Triangle& triangle = mesh_.triangles[t];
        return {project_(mesh_.points[triangle[0]]), project_(mesh_.points[triangle[1]]),
                project_(mesh_.points[triangle[2]])};
    }
    [[nodiscard]] LinePlace place_of(const Line& line, const LineCorners& p) const {
        return {p, project_.lattice_u.position(line.u), project_.lattice_v.position(line.v)};
    }

    [[nodiscard]] Bounds bounds_at(const GridPoint& point) const {
        const LinePoint p = project_(point);
        return Bounds{static_cast<std::int16_t>(project_.lattice_u.at_or_after(p.u)),
                      static_cast<std::int16_t>(-project_.lattice_u.at_or_before(p.u)),
                      static_cast<std::int16_t>(project_.lattice_v.at_or_after(p.v)),
                      static_cast<std::int16_t>(-project_.lattice_v.at_or_before(p.v))};
    }
    void bound_points() {
        bounds_.clear();
        bounds_.reserve(mesh_.points.size());
        for (const GridPoint& point : mesh_.points) bounds_.push_back(bounds_at(point));
    }
    [[nodiscard]] Bounds bounds_of(std::uint32_t point) const {
        return bounds_.empty() ? bounds_at(mesh_.points[point]) : bounds_[point];
    }

    /// The triangles that lines may cross; most of a fine mesh lie between the lines.
    std::size_t take_boxes(std::span<const std::uint32_t> triangles) {
        std::size_t count = 0;
        for (const std::uint32_t t : triangles) {
            const auto [i, j, k] = mesh_.triangles[t];
            const Bounds a = bounds_of(i), b = bounds_of(j), c = bounds_of(k);
            const Bounds ab = a < b ? a : b;
            const Bounds least = ab < c ? ab : c;
            boxes_[count].bounds = least;
            boxes_[count].triangle = t;
            // Without a branch: half of them are passed over.
            count += static_cast<std::size_t>(boxes_[count].width() > 0) &
                     static_cast<std::size_t>(boxes_[count].height() > 0);
        }
        return count;
    }

    [[nodiscard]] bool meets_only(const Boxed& boxed) const {
        for (int v = boxed.bounds[2]; v <= -boxed.bounds[3]; ++v) {
            for (int u = boxed.bounds[0]; u <= -boxed.bounds[1]; ++u) {
                if (only_->test(u, v, 0)) return true;
            }
        }
        return false;
    }

    /// Lists one, two or four lines.
    std::size_t list_lines(const Boxed& boxed, std::size_t lines) {
        const int u = boxed.bounds[0], v = boxed.bounds[2];
        const std::size_t more_u = boxed.width() > 1 ? 1 : 0;
        const std::size_t more_v = boxed.height() > 1 ? 1 : 0;
        lines_[lines] = {boxed.triangle, u, v};
        lines_[lines + 1] = {boxed.triangle, u + 1, v};
        lines += 1 + more_u;
        lines_[lines] = {boxed.triangle, u, v + 1};
        lines_[lines + 1] = {boxed.triangle, u + 1, v + 1};
        return lines + more_v + (more_u & more_v);
    }

    /// Returns whether to go on.
    template <typename Visit>
    bool visit_rows(const Boxed& boxed, Visit&& visit) const {
        const LineCorners p = corners(boxed.triangle);
        const std::int64_t area = side_of(p.b, p.c, p.a.u, p.a.v);
        if (area == 0) return true;
        const int u0 = boxed.bounds[0], v0 = boxed.bounds[2];
        LineRows rows(p, project_.lattice_u.position(u0), project_.lattice_v.position(v0), area);
        std::uint64_t crossings = 0;
        rows.visit(boxed.width(), boxed.height(),
                   [&](std::int32_t du, std::int32_t dv, std::int32_t depth) {
                       if (only_ != nullptr && !only_->test(u0 + du, v0 + dv, 0)) return;
                       ++crossings;
                       visit(u0 + du, v0 + dv, depth, boxed.triangle, area < 0);
                   });
        return meter_.count(static_cast<std::uint64_t>(boxed.height()), crossings);
    }

    const GridMesh& mesh_;
    LineProjection project_;
    const BitVolume* only_;
    CastMeter& meter_;
    std::vector<Bounds> bounds_;  ///< of each point, or empty
    std::array<Boxed, kChunk + 1> boxes_;
    std::array<Line, 4 * kChunk + 4> lines_;
};

}  // namespace ossuary::voxel
