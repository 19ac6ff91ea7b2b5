#pragma once

#include <span>
#include <stop_token>

#include "engine/skeleton/skeleton_graph.h"

namespace ossuary::skeleton {

/// Pruning of thesis sec. 3.2.3: a leaf goes while the significance (eq. 3.3) of its tip v_m is
/// below  degree(v_m) * sum over the nodes of S(v_n) / degree(v_n), divided by (t_k * n),  the sum
/// over the n junctions and ends. The least significant goes first, and significances are taken
/// anew after each, since removal lengthens the branches that are left. No cycle and no component
/// goes.
/// Ends early when stopped.
/// @param surface             points of the surface in the graph's coordinates
/// @param significance_scale  t_k; larger prunes less
void prune_by_significance(SkeletonGraph& graph, std::span<const Vec3> surface,
                           double significance_scale, const std::stop_token& stop = {});

}  // namespace ossuary::skeleton
