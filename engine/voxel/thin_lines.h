#pragma once

#include <cstdint>
#include <vector>

#include "engine/voxel/bit_volume.h"
#include "engine/voxel/grid_mesh.h"

namespace ossuary {

/// Where a solid, sampled at voxel centres, may have lost something of its surface.
struct ThinPlaces {
    BitVolume thick;  ///< the thick parts of the solid (morphology.h)
    /// Triangles with a corner that has nothing thick around it, or longer than two voxels, so that
    /// the corners do not tell enough. Elsewhere lines that miss all centres only graze the
    /// outline.
    std::vector<std::uint32_t> triangles;
};
ThinPlaces find_thin_places(const GridMesh& mesh, const BitVolume& solid);

/// The lines along an axis that pass by thin places: bit (u, v, 0) is the line with these
/// coordinates along axis + 1 and axis + 2.
BitVolume lines_past(const GridMesh& mesh, const ThinPlaces& places, int axis);

}  // namespace ossuary
