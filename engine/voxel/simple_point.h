#pragma once

#include <cstdint>

#include "engine/voxel/bit_volume.h"

namespace ossuary::voxel {

/// Whether setting or clearing a voxel leaves the topology (26, 6) as it is: around it, without
/// itself, there is exactly one object component by 26-neighbours and exactly one background
/// component by faces, within the 18-neighbours, that touches one of its faces (Bertrand &
/// Malandain, "A new characterization of three-dimensional simple points", 1994).
/// @pre the voxel is not in the outermost layer
bool is_simple_point(const BitVolume& volume, const Vec3i& voxel);

}  // namespace ossuary::voxel
