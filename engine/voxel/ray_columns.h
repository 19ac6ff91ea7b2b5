#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/voxel/cast_meter.h"
#include "engine/voxel/grid_mesh.h"

namespace ossuary::voxel {

/// A family of parallel lines through all voxel centres: a step of one voxel along `axis` goes with
/// steps of shear[0] along axis + 1 and shear[1] along axis + 2 (cyclic), each -1, 0 or 1.
struct LineDirection {
    int axis = 0;
    std::array<int, 2> shear = {0, 0};
    /// Cast only the lines (u, v) with bit (u, v, 0) set; without shear, and not null, only.
    const BitVolume* only = nullptr;
};

/// Some of the lines along an axis.
struct LineSubset {
    BitVolume lines;  ///< bit (u, v, 0): the line with these coordinates along axis + 1, axis + 2
    std::vector<std::uint32_t> triangles;  ///< all that a line crosses, and perhaps more
};

/// The three axes.
inline constexpr std::array<LineDirection, 3> kAxisDirections = {LineDirection{0, {0, 0}, nullptr},
                                                                 LineDirection{1, {0, 0}, nullptr},
                                                                 LineDirection{2, {0, 0}, nullptr}};

/// The thirteen directions between a voxel and its 26 neighbours: axes, face and space diagonals.
inline constexpr std::array<LineDirection, 13> kThirteenDirections = {
    LineDirection{0, {0, 0}, nullptr},  LineDirection{1, {0, 0}, nullptr},
    LineDirection{2, {0, 0}, nullptr},  LineDirection{0, {1, 0}, nullptr},
    LineDirection{0, {-1, 0}, nullptr}, LineDirection{1, {1, 0}, nullptr},
    LineDirection{1, {-1, 0}, nullptr}, LineDirection{2, {1, 0}, nullptr},
    LineDirection{2, {-1, 0}, nullptr}, LineDirection{0, {1, 1}, nullptr},
    LineDirection{0, {1, -1}, nullptr}, LineDirection{0, {-1, 1}, nullptr},
    LineDirection{0, {-1, -1}, nullptr}};

/// Where a line crosses a triangle.
struct Crossing {
    std::int32_t u = 0;  ///< of the line: voxel coordinate along axis + 1 where it meets plane 0
    std::int32_t v = 0;  ///< the same along axis + 2
    std::int32_t depth = 0;  ///< along `axis`, in fixed point, rounded up
    std::uint32_t part : 30 = 0;
    std::uint32_t entering : 1 = 0;  ///< 1 when the triangle faces the line's start
};

/// The first voxel along the line whose centre is not before `depth`.
inline std::int32_t first_centre_from(std::int32_t depth) {
    return (depth + kGridHalf - 1) >> kGridBits;
}

/// All crossings of the lines with the given triangles, sorted by line and depth. Lines through an
/// edge or a corner are treated as if moved by an infinitesimal amount, the same for all triangles:
/// a closed surface is entered as often as it is left. Triangles seen edge-on are not crossed.
/// @param triangles  indices into mesh.triangles
/// @param part_of    for each triangle of the mesh
/// Not complete where the meter says so.
std::vector<Crossing> cast_lines(const GridMesh& mesh, std::span<const std::uint32_t> triangles,
                                 std::span<const std::uint32_t> part_of,
                                 const LineDirection& direction, CastMeter& meter);

/// Calls visit(begin, end) for the crossings of each line in turn.
template <typename Visit>
void for_each_line(std::span<const Crossing> crossings, Visit&& visit) {
    for (std::size_t begin = 0; begin < crossings.size();) {
        std::size_t end = begin + 1;
        while (end < crossings.size() && crossings[end].u == crossings[begin].u &&
               crossings[end].v == crossings[begin].v) {
            ++end;
        }
        visit(crossings.subspan(begin, end - begin));
        begin = end;
    }
}

/// The voxel number k (along the axis) of a line.
inline Vec3i voxel_on_line(const LineDirection& direction, std::int32_t u, std::int32_t v,
                           std::int32_t k) {
    Vec3i voxel;
    voxel[direction.axis] = k;
    voxel[(direction.axis + 1) % 3] = u + direction.shear[0] * k;
    voxel[(direction.axis + 2) % 3] = v + direction.shear[1] * k;
    return voxel;
}

}  // namespace ossuary::voxel
