#pragma once

#include "engine/skeleton/finer_paths.h"

namespace ossuary::skeleton {

/// The voxels that the paths of tips may lead through: the solid's in the tree's blocks, and of
/// those beside a block what is about as deep as it. The tree's blocks hold the deepest voxels
/// nearby, so that the middle of the solid is not far outside.
/// @pre blocks of edge 1 or 2: then voxels are joined where their blocks are linked
ThinningGrid corridor_along(const PathsInBlocks& paths, const voxel::BitVolume& solid,
                            const voxel::DistanceField& distance);

}  // namespace ossuary::skeleton
