#pragma once

#include <cstddef>

#include "engine/voxel/bit_volume.h"

namespace ossuary::voxel {

/// How many components of the background, by faces, do not reach the outside. Only stretches of
/// background between set voxels of a row are looked at, since everything else is outside: a tenth
/// of the time of labelling the background.
[[nodiscard]] std::size_t count_cavities(const BitVolume& volume);

}  // namespace ossuary::voxel
