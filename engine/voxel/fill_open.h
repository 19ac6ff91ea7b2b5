#pragma once

#include "engine/voxel/bit_volume.h"
#include "engine/voxel/cast_meter.h"
#include "engine/voxel/grid_mesh.h"
#include "engine/voxel/surface_parts.h"

namespace ossuary::voxel {

/// Sets the voxels that the open parts of a surface enclose, by the vote of the lines through each
/// voxel in thirteen directions: a line that crosses the surface an even number of times votes by
/// the parity before the voxel, any other has passed through a hole and is silent. Each part is
/// looked at on its own, so that overlapping parts unite, and all together, for models of separate
/// polygons. Not complete where the meter says so.
void fill_open_parts(const GridMesh& mesh, const SurfaceParts& parts, CastMeter& meter,
                     BitVolume& volume);

}  // namespace ossuary::voxel
