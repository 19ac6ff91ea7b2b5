#pragma once

#include <stop_token>

#include "engine/skeleton/skeleton_graph.h"

namespace ossuary::skeleton {

struct ProtrusionOptions {
    double min_protrusion = 1.6;  ///< reach / junction radius below which a leaf goes
    int max_leaves = 24;          ///< raise the threshold by a tenth until at most this many
    bool merge_junctions = true;  ///< contract inner branches shorter than the larger end radius
};

/// How far a leaf stands out of the ball at its junction, 1 for "not at all": the largest over its
/// points of (arc length from the junction + radius), divided by the junction's radius.
double protrusion(const SkeletonGraph& graph, std::uint32_t branch, std::uint32_t junction);

/// Removes the leaf that protrudes least until all reach min_protrusion, joining what is left of
/// dissolved junctions; then draws together junctions within one ball, and prunes again. Solids
/// with more than max_leaves left, such as cups and shells, are pruned harder. No cycle and no
/// component goes. Ends early when stopped.
void prune_by_protrusion(SkeletonGraph& graph, const ProtrusionOptions& options = {},
                         const std::stop_token& stop = {});

}  // namespace ossuary::skeleton
