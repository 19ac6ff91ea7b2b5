#pragma once

#include "engine/voxel/bit_volume.h"

namespace ossuary {

/// The Betti numbers of the foreground (26-connected) against its background (6-connected).
struct BettiNumbers {
    int components = 0;
    int tunnels = 0;
    int cavities = 0;
    bool operator==(const BettiNumbers&) const = default;
};

/// Counts components and cavities by labelling and tunnels by the Euler characteristic of the
/// (26, 6) cubical complex: tunnels = components + cavities - euler.
BettiNumbers betti_numbers(const BitVolume& volume);

}  // namespace ossuary
