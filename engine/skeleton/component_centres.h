#pragma once

#include <cstdint>
#include <vector>

#include "engine/skeleton/thinning_grid.h"
#include "engine/voxel/distance_transform.h"

namespace ossuary::skeleton {

/// The deepest voxel of a 26-connected component; of several the nearest to the component's centre
/// of gravity, which does not depend on the order of the axes.
struct ComponentCentre {
    VoxelIndex voxel = 0;  ///< in PaddedShape(solid.size())
    std::uint32_t squared_radius = 0;
};

/// One for each 26-component of the solid, in the order of their first voxels.
std::vector<ComponentCentre> component_centres(const voxel::BitVolume& solid,
                                               const voxel::DistanceField& distance);

}  // namespace ossuary::skeleton
