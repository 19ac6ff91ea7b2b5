#pragma once

#include <cstdint>
#include <vector>

#include "engine/voxel/bit_volume.h"

namespace ossuary {

/// The squared distance transform by lower envelopes of parabolas (Felzenszwalb & Huttenlocher,
/// "Distance transforms of sampled functions", 2012, sec. 2), within each run of set voxels: linear
/// in the number of set voxels, whatever their distances. Values x fastest, then y, then z.
/// @pre no side above 2^14
std::vector<std::uint32_t> distances_by_envelope(const BitVolume& volume);

}  // namespace ossuary
