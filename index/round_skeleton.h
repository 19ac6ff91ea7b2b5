#pragma once

#include "engine/skeleton/skeleton_graph.h"

namespace ossuary::index {

/// The skeleton with its coordinates and radii rounded to multiples of a power of two, between
/// 2^-19 and 2^-18 of its extent: some thousandths of a voxel, and two bytes where there were eight
/// (codec.h writes multiples as such).
[[nodiscard]] skeleton::SkeletonGraph round_skeleton(skeleton::SkeletonGraph graph);

}  // namespace ossuary::index
