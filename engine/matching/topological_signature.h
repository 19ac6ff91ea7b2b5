#pragma once

#include <cstdint>
#include <vector>

#include "engine/matching/tree_shape.h"

namespace ossuary::matching {

struct SkeletonDescriptor;

/// A skeleton graph as the rooted hierarchy that the thesis' matching walks (sec. 3.3.1): the root
/// is the most significant node, every other node hangs from its neighbour on the shortest way to
/// the root. Branches that close a cycle belong to no node of the tree. Of several components the
/// one with the most significant node gives the root; the others' hang from it without a branch.
struct SignatureTree {
    struct Node {
        std::uint32_t graph_node = 0;
        std::uint32_t parent = 0xFFFFFFFFU;         ///< none at the root
        std::uint32_t parent_branch = 0xFFFFFFFFU;  ///< none at a component's root
        std::uint32_t rank = 0;              ///< place by significance, then radius; 0 = first
        std::uint32_t first_in_subtree = 0;  ///< the subtree is the nodes from here to this one
        /// Topological signature vector (Siddiqi, Shokoufandeh, Dickinson, Zucker, "Shock graphs
        /// and shape matching", IJCV 35, 1999, sec. 4): the eigenvalue sum of the node's own
        /// subtree, then those of its children's in decreasing order; the eigenvalue sum of a
        /// subtree is that of the k largest absolute eigenvalues of its adjacency matrix, k the
        /// number of children of its root. Empty at end points.
        std::vector<float> signature;
    };
    std::vector<Node> nodes;  ///< in post-order; the root is the last
    TreeShape shape;          ///< of `nodes`
};

struct SignatureOptions {
    /// Larger subtrees count with the nodes nearest to their root: the cost is cubic.
    int max_matrix_size = 96;
};

[[nodiscard]] SignatureTree signature_tree(const SkeletonDescriptor& descriptor,
                                           const SignatureOptions& options = {});

/// The sum of the k largest absolute eigenvalues of the adjacency matrix of the subtree below
/// `node`, k the number of its children; 0 for an end point.
[[nodiscard]] double eigenvalue_sum(const TreeShape& tree, std::uint32_t node, int max_matrix_size);

}  // namespace ossuary::matching
