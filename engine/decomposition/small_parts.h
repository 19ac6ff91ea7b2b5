#pragma once

#include <cstdint>
#include <vector>

#include "engine/decomposition/surface_graph.h"

namespace ossuary::decomposition {

/// The share of the surface's area from which on a part is one: as many parts as people make (7.8
/// on average against 7.3; 8.8 without), and borders that are as near to theirs as without.
inline constexpr double kSmallestPart = 0.0085;

/// Gives parts below `share` of the area, the smallest first, to the part that they have the
/// longest border with. Parts without a border, loose pieces, stay.
/// @param part_of_triangle  numbers from 0
void join_small_parts(const SurfaceGraph& surface, std::vector<std::uint32_t>& part_of_triangle,
                      double share = kSmallestPart);

}  // namespace ossuary::decomposition
