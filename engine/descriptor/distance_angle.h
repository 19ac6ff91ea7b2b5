#pragma once

#include <vector>

#include "engine/descriptor/solid_surface.h"

namespace ossuary {

inline constexpr int kDistanceAngleSize = 32 * 8;

/// The joint histogram of the distance between two points of the surface, over the square root of
/// its area (Osada et al., "Shape distributions", 2002: D2), and of the absolute cosine between
/// their normals (Ohbuchi, Minamitani and Takei, "Shape-similarity search of 3D models by using
/// enhanced shape functions", 2003: AAD). Over all pairs of at most 700 points, so without a
/// random number. Compare by L1.
std::vector<float> distance_angle(const SolidSurface& surface);

}  // namespace ossuary
