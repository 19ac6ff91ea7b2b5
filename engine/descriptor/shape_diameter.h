#pragma once

#include <vector>

#include "engine/descriptor/shell_graph.h"
#include "engine/voxel/bit_volume.h"

namespace ossuary::descriptor {

/// The shape diameter of each node of `surface`, in voxels: rays through the solid in a cone of 60
/// degrees about the inward normal, their lengths averaged with the cosine as weight after those
/// further than one standard deviation from the median are left out (Shapira, Shamir and Cohen-Or,
/// "Consistent mesh partitioning and skeletonisation using the shape diameter function", 2008, sec.
/// 3). Rays go through voxels, so that a surface with holes needs no special care.
std::vector<float> shape_diameters(const ShellGraph& surface, const voxel::BitVolume& solid);

}  // namespace ossuary::descriptor
