#pragma once

#include <cstddef>
#include <stop_token>

#include "engine/voxel/betti.h"
#include "engine/voxel/bit_volume.h"

namespace ossuary::voxel {

/// How intricate a solid is: components, tunnels and cavities together.
[[nodiscard]] std::size_t intricacy(const BettiNumbers& shape);

/// Closes gaps, holes and pores of a solid (morphological closing with a cube, cavities filled),
/// the narrowest first and ever wider ones, until its intricacy is at most `most`: a sponge keeps
/// its wide tunnels and loses those of a voxel. What is set stays set; the two outermost layers
/// stay empty. Returns the width in voxels up to which gaps were closed; 0 for a solid that is
/// plain enough. When stopped, returns what there is by then.
/// @pre two empty layers on every side
int close_gaps(BitVolume& volume, std::size_t most, const std::stop_token& stop);

}  // namespace ossuary::voxel
