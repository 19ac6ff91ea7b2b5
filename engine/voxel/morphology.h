#pragma once

#include "engine/voxel/bit_volume.h"

namespace ossuary::voxel {

/// The volume grown by one voxel in all 26 directions, within its bounds.
BitVolume dilate(const BitVolume& volume);

/// The voxels of the volume all of whose 26 neighbours are set; outside counts as set.
BitVolume erode(const BitVolume& volume);

/// Whether a voxel or one of its 26 neighbours is in a part of the volume that is at least two
/// voxels thick: in a 2x2x2 block of set voxels.
/// @pre two voxels or more from the volume's border
bool is_near_thick_part(const BitVolume& volume, const Vec3i& voxel);

}  // namespace ossuary::voxel
