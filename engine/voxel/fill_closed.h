#pragma once

#include <cstdint>
#include <span>

#include "engine/voxel/bit_volume.h"
#include "engine/voxel/cast_meter.h"
#include "engine/voxel/grid_mesh.h"
#include "engine/voxel/ray_columns.h"
#include "engine/voxel/surface_parts.h"
#include "engine/voxel/voxel_set.h"

namespace ossuary::voxel {

/// Sets the voxels whose centre is inside some closed part: its winding number is not 0, or odd
/// where the part is closed by parity only.
/// @param crossings  of the closed parts with the lines along axis 0
void fill_inside(std::span<const Crossing> crossings, const SurfaceParts& parts, BitVolume& volume);

/// Adds the voxels in which lines along an axis pass through the closed parts without meeting a
/// voxel's centre: what sampling at centres loses of a part thinner than a voxel.
/// @param crossings  of the closed parts with the lines along `axis`
void add_missed(std::span<const Crossing> crossings, const SurfaceParts& parts, int axis,
                const GridMesh& mesh, VoxelSet& voxels);

/// Adds the voxels in which lines along an axis cross the triangles, unless a voxel of the solid
/// has its centre right before or behind the crossing. Not complete where the meter says so.
void add_crossed(const GridMesh& mesh, std::span<const std::uint32_t> triangles, int axis,
                 const BitVolume& solid, CastMeter& meter, VoxelSet& voxels);

}  // namespace ossuary::voxel
