#pragma once

#include <vector>

#include "engine/voxel/bit_volume.h"

namespace ossuary::voxel {

/// The set voxels with a background voxel beyond at least one face (outside counts as background),
/// x fastest, then y, then z.
std::vector<Vec3i> border_points(const BitVolume& volume);

/// The same as a volume.
BitVolume border(const BitVolume& volume);

}  // namespace ossuary::voxel
