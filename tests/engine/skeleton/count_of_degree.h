#pragma once

#include "engine/skeleton/skeleton_graph.h"

namespace ossuary::test {

/// How many nodes of the graph have so many branches.
inline int count_of_degree(const skeleton::SkeletonGraph& graph, int degree) {
    int count = 0;
    for (const skeleton::SkeletonGraph::Node& node : graph.nodes) count += node.degree == degree;
    return count;
}

}  // namespace ossuary::test
