#include "engine/voxel/thin_lines.h"

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

#include "engine/voxel/components.h"
#include "engine/voxel/morphology.h"

namespace ossuary {
namespace {

bool is_longer_than_two_voxels(const GridPoint& a, const GridPoint& b) {
    return std::abs(a[0] - b[0]) > 2 * kGridOne || std::abs(a[1] - b[1]) > 2 * kGridOne ||
           std::abs(a[2] - b[2]) > 2 * kGridOne;
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
            is_longer_than_two_voxels(mesh.points[a], mesh.points[b]) ||
            is_longer_than_two_voxels(mesh.points[b], mesh.points[c]) ||
            is_longer_than_two_voxels(mesh.points[c], mesh.points[a])) {
            places.triangles.push_back(t);
        }
    }
    return places;
}

BitVolume lines_past(const GridMesh& mesh, const ThinPlaces& places, int axis) {
    const auto axis_u = static_cast<std::size_t>((axis + 1) % 3);
    const auto axis_v = static_cast<std::size_t>((axis + 2) % 3);
    BitVolume lines({mesh.size[static_cast<int>(axis_u)], mesh.size[static_cast<int>(axis_v)], 1});
    for (const std::uint32_t t : places.triangles) {
        const auto [a, b, c] = mesh.triangles[t];
        const auto range = [&, p = a, q = b, r = c](std::size_t i) {
            const auto [low, high] =
                std::minmax({mesh.points[p][i], mesh.points[q][i], mesh.points[r][i]});
            return std::pair((low >> kGridBits) - 1, (high >> kGridBits) + 1);
        };
        const auto [u0, u1] = range(axis_u);
        const auto [v0, v1] = range(axis_v);
        for (int v = v0; v <= v1; ++v) set_run(lines, {u0, u1 + 1, v, 0, 0});
    }
    return lines;
}

}  // namespace ossuary
