#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/geometry.h"
#include "engine/descriptor/shell_graph.h"

namespace ossuary::descriptor {

inline constexpr std::size_t kPosePoints = 96;
inline constexpr std::size_t kPosePointsSize = 6 * kPosePoints;
inline constexpr double kPosePointsUnit = 1.0 / 4096.0;

/// How a body stands: points spread evenly over its surface, each the middle of the patch that is
/// nearest to it, in the order of farthest-point sampling, so that the first ones are spread too.
/// They are centred and lie along the axes of the file; their unit is the geometric mean of `scale`
/// and of their root mean square distance from the centre: by the former alone bodies with long
/// limbs differ from all others, by the latter alone a body that stretches out shrinks.
/// Little-endian 16-bit x y z, in 1 / 4096 of the unit.
/// @param scale     body_scale, in voxels
/// @param rotation  of the graph's grid in the file (WorldFromGrid::rotation)
[[nodiscard]] std::vector<std::uint8_t> pose_points(const ShellGraph& graph, double scale,
                                                    const Mat3& rotation);

/// How differently two bodies stand, whatever their limbs' lengths and girths: one is laid over the
/// other as well as it goes, and each point takes the nearest of the other body for its partner.
/// The distance is the geometric mean of two: the mean distance between partners, over the bodies'
/// size, and the mean of 1 - cos of the angle between the directions from point to point and from
/// partner to partner, over all pairs of points; each both ways. It is laid as the files lie,
/// and from there and from the best of the ways of laying principal axes over each other moved to
/// the closest points (Besl and McKay, "A method for registration of 3-D shapes", 1992). What lies
/// otherwise in its file stands otherwise, a little: half a turn makes the distance larger by a
/// tenth, mirroring by a twentieth. So a turned copy is still about at the distance 0, but of
/// bodies that stand about alike those come first that also face alike.
/// Symmetric bit by bit, 0 for equal points. @pre kPosePointsSize bytes each
[[nodiscard]] double pose_points_distance(std::span<const std::uint8_t> a,
                                          std::span<const std::uint8_t> b);

}  // namespace ossuary::descriptor
