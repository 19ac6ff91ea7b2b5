#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/voxel/bit_volume.h"
#include "engine/voxel/cast_meter.h"
#include "engine/voxel/grid_mesh.h"
#include "engine/voxel/voxel_set.h"

namespace ossuary::voxel {

/// Adds what sampling at voxel centres has lost of a surface to `volume`, as sheets and lines of
/// one voxel:
/// - the voxels of `thin` away from the thick parts of the volume stay;
/// - those around the thick parts stay only where the topology needs them (where they close a hole
///   or tie something to the volume); the others merely graze the outline;
/// - edges that still are more than a voxel away from everything are drawn in, up to where they
///   touch something.
/// A volume of parts thicker than two voxels comes back unchanged. Returns the number of voxels
/// added. Not complete where the meter says so.
/// @param thin   voxels in which a line along an axis passes through the surface and misses the
///               centre (add_missed, add_crossed)
/// @param places triangles along whose edges to look for lost ones: find_thin_places
std::size_t add_thin_parts(const GridMesh& mesh, const VoxelSet& thin,
                           const std::vector<std::uint32_t>& places, CastMeter& meter,
                           BitVolume& volume);

}  // namespace ossuary::voxel
