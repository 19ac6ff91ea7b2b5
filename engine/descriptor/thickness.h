#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/descriptor/shell_graph.h"

namespace ossuary::descriptor {

inline constexpr std::size_t kThicknessSize = 32;
inline constexpr std::size_t kThicknessPairsSize = 8 * 8 * 8;

/// How much of the surface has how much body below it: the histogram of the logarithm of the shape
/// diameter over the scale; square roots in bytes. Neither changes where limbs bend. Compare by L1.
/// @param diameters  shape_diameters(graph), voxels
/// @param scale      body_scale, voxels
std::vector<std::uint8_t> thickness(const ShellGraph& graph, std::span<const float> diameters,
                                    double scale);

/// Which thicknesses lie how far apart along the surface: the joint histogram of the geodesic
/// distance of two points over the scale and the logarithms of the smaller and of the larger of
/// their shape diameters; square roots in bytes. Compare by L1.
/// @param spread  from a few dozen sources
std::vector<std::uint8_t> thickness_pairs(const ShellGraph& graph, const SpreadDistances& spread,
                                          std::span<const float> diameters, double scale);

}  // namespace ossuary::descriptor
