#pragma once

#include <cstdint>
#include <vector>

namespace ossuary {

/// A skeleton graph as the rooted hierarchy that the thesis' matching walks (sec. 3.3.1): the root
/// is the most significant node, every other node hangs from its neighbour on the shortest way to
/// the root. Branches that close a cycle belong to no node of the tree.
struct SignatureTree {
    struct Node {
        std::uint32_t parent = 0xFFFFFFFFU;         ///< none at a root
        std::uint32_t parent_branch = 0xFFFFFFFFU;  ///< the branch to the parent
        std::uint32_t rank = 0;  ///< place by significance, radius and signature; 0 = first
        std::vector<std::uint32_t> children;
        /// Topological signature vector (Siddiqi, Shokoufandeh, Dickinson, Zucker, "Shock graphs
        /// and shape matching", IJCV 35, 1999, sec. 4): for each child the sum of the k largest
        /// absolute eigenvalues of the adjacency matrix of the subtree below it, k the child's
        /// number of children; decreasing. Empty at end points.
        std::vector<float> signature;
    };
    std::vector<Node> nodes;           ///< one for each node of the graph, in its order
    std::vector<std::uint32_t> order;  ///< parents before children; the most significant root first
};

}  // namespace ossuary
