#pragma once

#include <stop_token>

#include "engine/skeleton/thinning_grid.h"

namespace ossuary::skeleton {

/// Fully parallel thinning (thesis sec. 3.2.1): in each iteration the voxels that fit a deletion
/// template are the candidates, and those among them that are P-simple for the candidates go at
/// once. Where even widths bring this to a halt (both sides of a pair are candidates and protect
/// each other), one pass over the simple points that face a single side breaks the tie. Topology is
/// kept by P-simplicity alone. Small crowds may be left for thin_to_unit_width.
ThinningGrid thin_in_parallel(const voxel::BitVolume& solid, const std::stop_token& stop = {});

}  // namespace ossuary::skeleton
