#pragma once

#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/mesh/triangle_mesh.h"
#include "engine/voxel/bit_volume.h"

namespace ossuary {

struct VoxelizeOptions {
    int resolution = 96;  ///< voxels along the longest side of the bounding box, in [8, 1024]
};

/// A model as a solid: no cavity unless the model truly has one is not promised here;
/// `filled_cavities` says what was closed.
struct VoxelSolid {
    BitVolume volume;  ///< at least one empty layer on every side
    WorldFromGrid world_from_grid;
    std::vector<MeshWarning> warnings;  ///< e.g. open_surface, dropped_components
    std::string method;                 ///< how the inside was found: parity, winding, closing, …
};

/// Turns any mesh into a solid volume: watertight meshes exactly (a voxel is set when its centre is
/// inside), polygon soups robustly, so that an open or thin-walled model still gives one solid.
/// Parts thinner than a voxel are kept by rasterising the surface where the interior would lose it.
/// Errors: mesh_empty, mesh_no_extent, solid_empty, invalid_argument.
Result<VoxelSolid> voxelize(const TriangleMesh& mesh, const VoxelizeOptions& options = {});

}  // namespace ossuary
