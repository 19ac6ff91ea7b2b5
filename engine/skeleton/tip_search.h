#pragma once

#include <stop_token>

#include "engine/skeleton/block_grid.h"
#include "engine/skeleton/thinning.h"

namespace ossuary::skeleton {

struct Tips {
    std::vector<VoxelIndex> blocks;  ///< in the order found, the farthest from all others first
    ThinningGrid tree;               ///< the blocks of all paths from centres to tips
};

/// The tips of a solid. Paths from the centres follow the shortest way with step cost length / r^2.
/// A tip is taken while some block x has min over path blocks t of
/// geodesic(x, t) - radius_factor * r(t) above `coverage`: the farthest first, at most max_tips in
/// all.
/// @param centres   one block for each component
/// @param coverage  in voxels
/// @param stop  once requested, the tips are not complete and their paths must not be followed
Tips find_tips(const BlockGrid& blocks, const std::vector<VoxelIndex>& centres, double coverage,
               const ThinningOptions& options, const std::stop_token& stop = {});

}  // namespace ossuary::skeleton
