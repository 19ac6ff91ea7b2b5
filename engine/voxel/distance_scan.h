#pragma once

#include <optional>
#include <stop_token>

#include "engine/voxel/distance_field.h"

namespace ossuary::voxel {

/// The largest distance that distances_by_scan finds: its square and that of a step a little longer
/// fit 16 bits together.
inline constexpr int kFarthestScan = 178;

/// The squared distance transform by looking up and down each column as far as a nearer background
/// could be, 16 columns at once: a step is a few vector instructions of 16-bit values, so that it
/// pays up to distances of some hundred voxels.
/// @return nothing where some voxel is farther than kFarthestScan: none is up to twice that a side
std::optional<DistanceField> distances_by_scan(const BitVolume& volume,
                                               const std::stop_token& stop = {});

}  // namespace ossuary::voxel
