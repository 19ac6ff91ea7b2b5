#pragma once

#include <cstdint>
#include <span>

#include "engine/voxel/bit_volume.h"
#include "engine/voxel/cast_meter.h"
#include "engine/voxel/grid_mesh.h"
#include "engine/voxel/ray_columns.h"
#include "engine/voxel/surface_parts.h"

namespace ossuary::voxel {

/// Sets the voxels whose centre is inside closed parts, on all lines along axis 0 on which parity
/// tells as much as winding numbers do: each crossing flips a bit, and a running sum modulo two
/// along the row is the inside. A sixth less time than sorting crossings line by line.
/// Returns the lines that this does not suffice for, and leaves them empty:
/// - two crossings between the same two centres (they may lose a thin part);
/// - crossings of several parts (they unite, whichever way each of them faces);
/// - crossings that do not enter and leave by turns (winding numbers beyond one).
/// @param closed  triangles of the closed parts
/// Not complete where the meter says so.
/// @pre the volume is empty
LineSubset fill_by_parity(const GridMesh& mesh, std::span<const std::uint32_t> closed,
                          const SurfaceParts& parts, CastMeter& meter, BitVolume& volume);

/// Of some lines along an axis those that cross twice between the same two centres.
LineSubset find_shared_gaps(const GridMesh& mesh, const LineSubset& past, int axis,
                            CastMeter& meter);

}  // namespace ossuary::voxel
