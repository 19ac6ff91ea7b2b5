#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/descriptor/shell_graph.h"

namespace ossuary::descriptor {

inline constexpr std::size_t kRadialThicknessSize = 12 * 10 * 5;

/// Where the body is how thick: the joint histogram of the distance from the centre of gravity over
/// its mean, the logarithm of the shape diameter over the square root of the area, and the cosine
/// between the normal and the direction away from the centre; square roots in bytes. Compare by L1.
/// @param diameters  shape_diameters(graph)
std::vector<std::uint8_t> radial_thickness(const ShellGraph& graph,
                                           std::span<const float> diameters);

}  // namespace ossuary::descriptor
