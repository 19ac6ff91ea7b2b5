#pragma once

#include "engine/voxel/bit_volume.h"

namespace ossuary {

/// The volume grown by one voxel in all 26 directions, within its bounds.
BitVolume dilate(const BitVolume& volume);

/// The voxels of the volume all of whose 26 neighbours are set; outside counts as set.
BitVolume erode(const BitVolume& volume);

/// The union of all 2x2x2 blocks within the volume: its parts at least two voxels thick.
BitVolume thick_parts(const BitVolume& volume);

}  // namespace ossuary
