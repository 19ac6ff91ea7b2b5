#pragma once

#include <stop_token>

#include "engine/skeleton/thinning_grid.h"
#include "engine/voxel/distance_transform.h"

namespace ossuary::skeleton {

/// Deletes simple points of `solid` that are not in `keep`, one at a time, by increasing distance
/// from the background, until none is left or `stop` is requested.
ThinningGrid peel(const voxel::BitVolume& solid, const voxel::DistanceField& distance,
                  const ThinningGrid& keep, const std::stop_token& stop = {});

}  // namespace ossuary::skeleton
