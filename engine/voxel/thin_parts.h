#pragma once

#include <cstddef>

#include "engine/voxel/bit_volume.h"
#include "engine/voxel/grid_mesh.h"

namespace ossuary {

/// Adds what sampling at voxel centres has lost of a surface to `volume`, as sheets and lines of
/// one voxel:
/// - the voxels of `thin` that lie off the volume stay;
/// - the voxels of `thin` that touch it stay only where the topology needs them (they close a hole
///   in a wing or tie two islands together); the others would merely thicken its rim;
/// - edges that still are more than a voxel away from everything are drawn in, with what ties
///   them to the rest.
/// A volume of parts thicker than a voxel comes back unchanged. Returns the number of voxels added.
/// @param thin  voxels in which a line along an axis passes through the surface and misses the
///              centre (mark_missed, mark_crossed)
std::size_t add_thin_parts(const GridMesh& mesh, const BitVolume& thin, BitVolume& volume);

}  // namespace ossuary
