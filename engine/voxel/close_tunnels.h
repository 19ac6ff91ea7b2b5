#pragma once

#include <cstddef>
#include <stop_token>

#include "engine/voxel/bit_volume.h"

namespace ossuary::voxel {

/// Fills tunnels about two voxels wide and less, as voxelization makes them where two parts of a
/// model nearly touch (fingers, a hand on a hip): of the voxels that a morphological closing by
/// one voxel would set, those connected sets are set that raise the Euler characteristic, that is,
/// that close a tunnel. Returns the number of sets. Pockets may turn into cavities: fill them
/// afterwards. When stopped, the rest stays open.
/// @pre two empty layers on every side
std::size_t close_small_tunnels(BitVolume& volume, const std::stop_token& stop = {});

}  // namespace ossuary::voxel
