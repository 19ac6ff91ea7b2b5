#pragma once

#include "engine/skeleton/skeleton_graph.h"

namespace ossuary::skeleton {

/// The end of a branch that hangs on a junction by its other end: a leaf.
struct Leaf {
    std::uint32_t branch = 0;
    std::uint32_t tip = 0;       ///< node of degree 1
    std::uint32_t junction = 0;  ///< node of degree above 2
};

/// All leaves, by branch. A branch between two ends is a whole component and no leaf.
/// @pre degrees are up to date
std::vector<Leaf> leaves(const SkeletonGraph& graph);

/// Removes a leaf's branch and tip. A junction that keeps two ends of different branches is
/// dissolved, so that these become one branch. Components and cycles stay; indices change.
void remove_leaf(SkeletonGraph& graph, const Leaf& leaf);

/// Joins the branches at every node of degree 2 that is not the node of a closed curve.
void join_degree_two_nodes(SkeletonGraph& graph);

/// Draws a branch between two different nodes together into one node, whose position is their mean
/// weighted by radius. Components and cycles stay; indices change. @pre branch.a != branch.b
void contract_branch(SkeletonGraph& graph, std::uint32_t branch);

}  // namespace ossuary::skeleton
