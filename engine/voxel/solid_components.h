#pragma once

#include <cstddef>
#include <stop_token>

#include "engine/voxel/bit_volume.h"

namespace ossuary::voxel {

struct JoinedComponents {
    std::size_t bridged = 0;  ///< bridges built
    std::size_t dropped = 0;  ///< components removed
    std::size_t dropped_voxels = 0;
    std::size_t remaining = 0;
};

struct JoinOptions {
    int bridge_gap = 2;
    double min_component_extent = 0.1;
};

/// Joins what is nearly one piece and drops specks: see VoxelizeOptions. Bridges are straight lines
/// between the nearest voxels of two components, shortest first, none between components that are
/// joined already, so that no tunnel comes of it. When stopped, the outcome is not complete.
JoinedComponents join_components(BitVolume& volume, const JoinOptions& options,
                                 const std::stop_token& stop = {});

}  // namespace ossuary::voxel
