#pragma once

#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "engine/chain_code/code_batch.h"
#include "engine/chain_code/direction_code.h"
#include "engine/matching/tree_shape.h"

namespace ossuary::matching {

struct SkeletonDescriptor;

inline constexpr std::uint32_t kNoIndex = 0xFFFFFFFFU;

/// A skeleton hung up at one node as a tree whose cycles are cut at the point as far from the root
/// one way as the other. A tree node stands for the piece of branch that leads to it from its
/// parent.
struct RootedTree {
    struct Node {
        std::uint32_t piece =
            kNoIndex;  ///< into RootedSkeletons::pieces; none at a component's root
        std::uint32_t graph_node = kNoIndex;  ///< none where a cycle was cut
        std::uint32_t parent = kNoIndex;      ///< none at the root
        float weight = 0.0F;         ///< the piece's length over the scale; a root's blob weight
        float root_distance = 0.0F;  ///< from the root to the piece's beginning, over the scale
        float radius = 0.0F;         ///< at the node, over the scale; 0 where a cycle was cut
    };
    std::vector<Node> nodes;            ///< children before parents; the root is the last
    std::vector<std::uint32_t> merged;  ///< of each node, the node of MergedTrees
    float total_weight = 0.0F;          ///< of all nodes
};

/// The trees from all candidate roots with what they share in one place: a subtree that hangs the
/// same way from two roots is there once. Comparing two skeletons compares each of these nodes
/// once, whatever the number of roots (a quarter of the work of four pairings of roots).
struct MergedTrees {
    struct Node {
        std::uint32_t piece = kNoIndex;  ///< as in RootedTree
        float weight = 0.0F;
        float radius = 0.0F;
    };
    std::vector<Node> nodes;  ///< children before parents
    TreeShape shape;          ///< of `nodes`; a node may have several parents
};

/// The trees from each candidate root. Their pieces of branch are shared: the same branch walked
/// the same way is one piece.
struct RootedSkeletons {
    struct Piece {
        std::uint32_t branch = 0;
        std::uint32_t first_step = 0;  ///< into `steps`
        std::uint32_t step_count = 0;
        float length = 0.0F;  ///< over the scale
    };
    std::vector<chain_code::DirectionStep>
        steps;  ///< direction codes of all pieces, away from the root
    std::vector<Piece> pieces;
    chain_code::CodeBatch batch;    ///< the same codes, laid out for aligning one with all
    MergedTrees merged;             ///< of `trees`
    std::vector<RootedTree> trees;  ///< best root first; empty only for an empty skeleton
    std::uint64_t content_key = 0;  ///< hash of nodes and branches as they are numbered
    std::uint64_t shape_key = 0;    ///< the same however they are numbered

    [[nodiscard]] std::span<const chain_code::DirectionStep> code(std::uint32_t piece) const {
        const Piece& p = pieces[piece];
        return {steps.data() + p.first_step, p.step_count};
    }
};

/// A fixed order of two skeletons, in which they are compared so that it makes no difference which
/// is named first; nor, but for skeletons of the same radii, how their nodes are numbered.
[[nodiscard]] inline bool in_order(const RootedSkeletons& a, const RootedSkeletons& b) {
    return std::tie(a.shape_key, a.content_key) <= std::tie(b.shape_key, b.content_key);
}

struct RootingOptions {
    /// First tier of the ten classes with 1, 2, 3 and 4 roots: .762, .784, .783, .783.
    int candidate_roots = 2;        ///< trees to make, from the most central roots
    double centrality_power = 1.0;  ///< a point of the skeleton counts as its radius to this power
    double root_blob_weight = 0.6;  ///< a root's own weight, as a multiple of its radius
    /// Of a tree; beyond that the shortest leaves are left out. With 96, 32, 24 and 18 a pair takes
    /// 34, 30, 26 and 22 us and the first tier of the ten classes is .864, .862, .862 and .859.
    int max_pieces = 24;
};

/// Hangs a skeleton up at its candidate roots: the junctions (of a curve the ends, of a ring its
/// nodes) with the smallest radius-weighted sum of geodesic distances to the whole skeleton. Of
/// several components the heaviest gives the root and the others' roots become its children.
[[nodiscard]] RootedSkeletons root_skeleton(const SkeletonDescriptor& descriptor,
                                            const RootingOptions& options = {});

}  // namespace ossuary::matching
