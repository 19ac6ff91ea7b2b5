#pragma once

#include "engine/skeleton/thinning_grid.h"
#include "engine/voxel/distance_transform.h"

namespace ossuary {
inline namespace skeleton {

/// Deletes simple points of `solid` that are not in `keep`, one at a time, by increasing distance
/// from the background, until none is left.
ThinningGrid peel(const BitVolume& solid, const DistanceField& distance, const ThinningGrid& keep);

}  // namespace skeleton
}  // namespace ossuary
