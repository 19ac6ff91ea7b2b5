#pragma once

#include "engine/skeleton/thinning_grid.h"
#include "engine/voxel/distance_transform.h"

namespace ossuary::skeleton {

/// Deletes simple points of `solid` that are not in `keep`, one at a time, by increasing distance
/// from the background, until none is left.
ThinningGrid peel(const voxel::BitVolume& solid, const voxel::DistanceField& distance,
                  const ThinningGrid& keep);

}  // namespace ossuary::skeleton
