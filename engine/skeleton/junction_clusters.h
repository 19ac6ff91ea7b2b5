#pragma once

#include <vector>

#include "engine/skeleton/thinning_grid.h"

namespace ossuary::skeleton {

/// Splits a 26-connected set of voxels into pieces without tunnels or cavities, so that each can be
/// drawn together into one node. Most sets are one piece; a ring of junction voxels is several.
std::vector<std::vector<VoxelIndex>> contractible_pieces(const std::vector<VoxelIndex>& voxels,
                                                         const PaddedShape& shape);

/// In how many separate places two disjoint sets of voxels touch: the number of components of the
/// intersection of the two unions of closed cubes.
int contacts(const std::vector<VoxelIndex>& a, const std::vector<VoxelIndex>& b,
             const PaddedShape& shape);

}  // namespace ossuary::skeleton
