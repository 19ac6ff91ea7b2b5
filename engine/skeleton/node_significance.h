#pragma once

#include <span>
#include <stop_token>
#include <vector>

#include "engine/skeleton/skeleton_graph.h"

namespace ossuary::skeleton {

/// The second sum of eq. 3.3 (thesis sec. 3.2.3) for each node: its distances to the `closest`
/// nearest points of the surface (to all of them where there are fewer). Not complete when stopped.
std::vector<double> surface_distance_sums(const SkeletonGraph& graph, std::span<const Vec3> surface,
                                          const std::stop_token& stop = {},
                                          std::size_t closest = 10);

/// Sets every node's significance, eq. 3.3: 0 for nodes of degree 2, else the lengths of the
/// branches at the node (a loop counts once for each of its ends) plus the distance sum.
/// @pre degrees are up to date; distance_sums is as long as graph.nodes
void set_significance(SkeletonGraph& graph, std::span<const double> distance_sums);

}  // namespace ossuary::skeleton
