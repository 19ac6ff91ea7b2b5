#pragma once

#include <stop_token>

#include "engine/skeleton/thinning.h"
#include "engine/skeleton/thinning_grid.h"

namespace ossuary::skeleton {

/// What anchored thinning must not delete.
struct Anchors {
    ThinningGrid voxels;         ///< for each component of the solid a tree of centred paths
    std::size_t components = 0;  ///< of the solid
    /// Each voxel was a simple point of the set when it was added: the set is then a deformation of
    /// one point for each component, so that it has no tunnel and no cavity.
    bool contractible = true;
};

/// Finds the tips of a solid and joins them to its centres. In each component the centre is the
/// deepest voxel; paths follow the shortest way to it with step cost length / r^2. Tips are taken
/// while some voxel x has min over path voxels t of geodesic(x, t) - radius_factor * r(t) above
/// the coverage of the options: the farthest first, at most max_tips in all. Not complete when
/// stopped.
Anchors find_anchors(const voxel::BitVolume& solid, const voxel::DistanceField& distance,
                     const ThinningOptions& options, const std::stop_token& stop = {});

}  // namespace ossuary::skeleton
