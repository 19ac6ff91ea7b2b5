#pragma once

#include <cstdint>

#include "engine/voxel/bit_volume.h"

namespace ossuary::voxel {

/// The Betti numbers of the foreground (26-connected) against its background (6-connected).
struct BettiNumbers {
    int components = 0;
    int tunnels = 0;
    int cavities = 0;
    bool operator==(const BettiNumbers&) const = default;
};

/// Counts components and cavities by labelling and tunnels by the Euler characteristic of the
/// (26, 6) cubical complex: tunnels = components + cavities - euler. What lies outside the volume
/// is background; voxels in the outermost layer are fine. Linear in rows and runs.
BettiNumbers betti_numbers(const BitVolume& volume);

/// Vertices - edges + faces - cubes of the union of closed unit cubes, one a set voxel: the Euler
/// characteristic under (26, 6) connectivity (Kong & Rosenfeld, "Digital topology: introduction and
/// survey", 1989, sec. 6).
std::int64_t euler_characteristic(const BitVolume& volume);

}  // namespace ossuary::voxel
