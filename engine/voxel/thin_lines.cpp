#include "engine/voxel/thin_lines.h"

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

#include "engine/voxel/components.h"
#include "engine/voxel/morphology.h"

namespace ossuary {
namespace {

/// Longer triangles can hide something between their corners.
constexpr int kLongVoxels = 4;

bool is_long(const GridPoint& a, const GridPoint& b) {
    constexpr std::int32_t kLong = kLongVoxels * kGridOne;
    return std::abs(a[0] - b[0]) > kLong || std::abs(a[1] - b[1]) > kLong ||
           std::abs(a[2] - b[2]) > kLong;
}

}  // namespace

ThinPlaces find_thin_places(const GridMesh& mesh, const BitVolume& solid) {
    ThinPlaces places{thick_parts(solid), {}};
    const BitVolume near_thick = dilate(places.thick);
    std::vector<std::uint8_t> is_thin(mesh.points.size());
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        is_thin[i] = near_thick.test(mesh.voxel_of(mesh.points[i])) ? 0 : 1;
    }
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        if ((is_thin[a] | is_thin[b] | is_thin[c]) != 0 ||
            is_long(mesh.points[a], mesh.points[b]) || is_long(mesh.points[b], mesh.points[c]) ||
            is_long(mesh.points[c], mesh.points[a])) {
            places.triangles.push_back(t);
        }
    }
    return places;
}

LinesPast lines_past(const GridMesh& mesh, const std::vector<std::uint32_t>& candidates,
                     const ThinPlaces& places, int axis) {
    const auto axis_u = static_cast<std::size_t>((axis + 1) % 3);
    const auto axis_v = static_cast<std::size_t>((axis + 2) % 3);
    LinesPast past;
    past.lines =
        BitVolume({mesh.size[static_cast<int>(axis_u)], mesh.size[static_cast<int>(axis_v)], 1});
    std::vector<std::uint8_t> is_thin(mesh.triangles.size(), 0);
    for (const std::uint32_t t : places.triangles) {
        is_thin[t] = 1;
        const auto [a, b, c] = mesh.triangles[t];
        const auto range = [&, p = a, q = b, r = c](std::size_t i) {
            const auto [low, high] =
                std::minmax({mesh.points[p][i], mesh.points[q][i], mesh.points[r][i]});
            return std::pair((low >> kGridBits) - 1, (high >> kGridBits) + 1);
        };
        const auto [u0, u1] = range(axis_u);
        const auto [v0, v1] = range(axis_v);
        for (int v = v0; v <= v1; ++v) set_run(past.lines, {u0, u1 + 1, v, 0, 0});
    }
    // Of a triangle that is no thin place, and so not long, one corner tells.
    BitVolume around = past.lines;
    for (int i = 0; i <= kLongVoxels; ++i) around = dilate(around);
    std::vector<std::uint8_t> is_near(mesh.points.size());
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        const GridPoint& p = mesh.points[i];
        is_near[i] = around.test(p[axis_u] >> kGridBits, p[axis_v] >> kGridBits, 0) ? 1 : 0;
    }
    for (const std::uint32_t t : candidates) {
        if ((is_near[mesh.triangles[t][0]] | is_thin[t]) != 0) past.triangles.push_back(t);
    }
    return past;
}

}  // namespace ossuary
