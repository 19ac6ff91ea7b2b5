#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "engine/decomposition/surface_graph.h"

namespace ossuary::decomposition {

struct RefineBordersOptions {
    /// How far from where it was a border may move, in parts of the square root of the area.
    double reach = 0.05;
    /// How much cheaper than a flat one of equal length a border along a concave crease is: a side
    /// costs length * exp(-crease_weight * turn).
    double crease_weight = 4.0;
};

/// Moves the borders between parts to where they are shortest and follow concave creases (the
/// minima rule): for each two parts that touch, the cheapest cut within `reach` of their border, by
/// maximum flow (compare Katz and Tal, "Hierarchical mesh decomposition using fuzzy clustering and
/// cuts", 2003, sec. 5). No part disappears or falls apart by it.
/// On surfaces whose cuts take longer than some seconds the last borders stay where they are.
/// @param labels  the part of each triangle
void refine_borders(const SurfaceGraph& surface, std::vector<std::uint32_t>& labels,
                    const RefineBordersOptions& options = {}, const std::stop_token& stop = {});

}  // namespace ossuary::decomposition
