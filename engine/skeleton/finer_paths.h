#pragma once

#include <stop_token>

#include "engine/skeleton/tip_search.h"

namespace ossuary::skeleton {

/// Tips and the tree of their paths in blocks of one edge.
struct PathsInBlocks {
    BlockGrid blocks;
    Tips tips;
};

/// The same tips in blocks of half the edge, with paths along the coarse ones: each tip in the part
/// of its block that is farthest from the centre. Where the coarse tree joins what the solid does
/// not, paths are looked for in the whole solid.
/// @param centres  voxels, in PaddedShape(solid.size())
/// @param stop  once requested, there may be no tips
/// @pre the edge is even
PathsInBlocks finer_paths(const PathsInBlocks& coarse, const voxel::BitVolume& solid,
                          const voxel::DistanceField& distance,
                          const std::vector<VoxelIndex>& centres, const std::stop_token& stop = {});

}  // namespace ossuary::skeleton
