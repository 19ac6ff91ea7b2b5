#pragma once

#include "engine/voxel/distance_field.h"

namespace ossuary {

/// The largest side for which distances_by_scan is exact: the square of half of it and the square
/// of a step a little longer fit 16 bits together.
inline constexpr int kMaxScanSide = 356;

/// The squared distance transform by looking up and down each column as far as a nearer background
/// could be, 16 columns at once: a step is a few vector instructions of 16-bit values, so that it
/// pays up to distances of some hundred voxels.
/// @pre no side above kMaxScanSide
DistanceField distances_by_scan(const BitVolume& volume);

}  // namespace ossuary
