#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/descriptor/shell_graph.h"
#include "engine/voxel/bit_volume.h"

namespace ossuary::descriptor {

inline constexpr std::size_t kLocalVolumeSize = 12 * 8 + 8 * 8 * 6;

/// How full the solid is around the points of its surface, which tells ridges (little) from hollows
/// (much) and thin from thick (integral invariants: Pottmann, Wallner, Huang and Yang, "Integral
/// invariants for robust geometry processing", 2009, sec. 2; here in cubes instead of balls). Two
/// joint histograms, square roots in bytes: the share of set voxels within a tenth of the square
/// root of the area against the logarithm of the average geodesic distance; and the shares within a
/// small and a large cube against the distance from the centre. Compare by L1.
/// @param geodesics  average_geodesic_distances(graph)
std::vector<std::uint8_t> local_volume(const ShellGraph& graph, std::span<const float> geodesics,
                                       const voxel::BitVolume& solid);

}  // namespace ossuary::descriptor
