#pragma once

#include <vector>

#include "engine/descriptor/shell_graph.h"
#include "engine/voxel/bit_volume.h"

namespace ossuary {

/// The joint histogram of shape diameter (how thick the body is below a point) and average geodesic
/// distance (how far out the point lies): 16 x 16 bins over the logarithm of the one and the other,
/// both over the square root of the area, weighted by area. It does not change under bending.
/// Compare by L1.
std::vector<float> shape_diameter_geodesic(const ShellGraph& surface, const BitVolume& solid);
inline constexpr int kShapeDiameterGeodesicSize = 256;

}  // namespace ossuary
