#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/geometry.h"

namespace ossuary::chain_code {

/// The 26 directions to a voxel's neighbours, as unit vectors, in the order of (dx, dy, dz) from
/// (-1, -1, -1) to (1, 1, 1) with dx slowest and the centre left out.
inline constexpr int kDirectionCount = 26;
[[nodiscard]] const std::array<Vec3f, kDirectionCount>& directions26();

/// The number of the nearest of the 26 directions to `v`; ties go to the lower number.
/// @pre v is not the zero vector
[[nodiscard]] std::uint8_t quantize_direction(const Vec3f& v);

/// A radius on a logarithmic scale of 256 levels: level = ln(radius / 0.001) / 0.03, rounded and
/// clamped, so that radii over the square root of the surface area from 0.001 to 2.1 differ.
inline constexpr double kRadiusLevelStep = 0.03;
[[nodiscard]] std::uint8_t quantize_radius(double radius);

/// One step of a branch: its direction in the branch's own frame and the radius beside it.
struct DirectionStep {
    std::uint8_t direction = 0;     ///< 0-25
    std::uint8_t radius_level = 0;  ///< see quantize_radius
    bool operator==(const DirectionStep&) const = default;
};

/// The frame of a branch: x along the chord from its first to its last point, y towards the mean
/// deviation from the chord, z completing them with the sign that makes the third moment of the
/// deviation along z positive: a mirrored branch has the mirrored frame, so the same code.
/// A branch without a chord takes its first half's, a straight branch any y.
[[nodiscard]] Mat3 branch_frame(std::span<const Vec3f> points);

/// The direction code of a branch whose points are evenly spaced: one step for each pair of
/// neighbouring points, with the mean of their radii (the 26-direction code that the thesis' sec.
/// 5.3 asks for). Invariant under rotation, translation and mirroring of the points.
/// @pre points.size() == radii.size(), at least two points
[[nodiscard]] std::vector<DirectionStep> direction_code(std::span<const Vec3f> points,
                                                        std::span<const float> radii);

}  // namespace ossuary::chain_code
