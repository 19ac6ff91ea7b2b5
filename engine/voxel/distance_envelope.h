#pragma once

#include <stop_token>

#include "engine/voxel/distance_field.h"

namespace ossuary::voxel {

/// The squared distance transform by lower envelopes of parabolas (Felzenszwalb & Huttenlocher,
/// "Distance transforms of sampled functions", 2012, sec. 2), within each run of set voxels: linear
/// in the number of set voxels, whatever their distances. Values x fastest, then y, then z.
/// @pre no side above 2^14
DistanceField distances_by_envelope(const BitVolume& volume, const std::stop_token& stop = {});

}  // namespace ossuary::voxel
