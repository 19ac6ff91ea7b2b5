#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/chain_code/direction_code.h"

namespace ossuary {

inline constexpr std::uint32_t kNoIndex = 0xFFFFFFFFU;

/// A skeleton hung up at one node as a tree whose cycles are cut. A tree node stands for the piece
/// of branch that leads to it from its parent.
struct RootedTree {
    struct Node {
        std::uint32_t piece = kNoIndex;       ///< into RootedSkeletons::pieces; none at the root
        std::uint32_t graph_node = kNoIndex;  ///< none where a cycle was cut
        std::uint32_t parent = kNoIndex;      ///< none at the root
        std::uint32_t first_child = 0;        ///< into `children`
        std::uint32_t child_count = 0;
        float weight = 0.0F;         ///< the piece's length over the scale; the root's blob weight
        float root_distance = 0.0F;  ///< from the root to the piece's beginning, over the scale
    };
    std::vector<Node> nodes;              ///< children before parents; the root is the last
    std::vector<std::uint32_t> children;  ///< indices into `nodes`
    float root_radius = 0.0F;             ///< over the scale
    float total_weight = 0.0F;            ///< of all nodes
};

/// The trees from each candidate root. Their pieces of branch are shared: the same branch walked
/// the same way has one piece.
struct RootedSkeletons {
    struct Piece {
        std::uint32_t branch = 0;
        std::uint32_t first_step = 0;  ///< into `steps`
        std::uint32_t step_count = 0;
        float length = 0.0F;  ///< over the scale
    };
    std::vector<DirectionStep> steps;  ///< direction codes of all pieces, away from the root
    std::vector<Piece> pieces;
    std::vector<RootedTree> trees;  ///< best root first; empty only for an empty skeleton
    std::uint64_t content_key = 0;  ///< hash of nodes and branches: a fixed order of the arguments

    [[nodiscard]] std::span<const DirectionStep> code(std::uint32_t piece) const {
        const Piece& p = pieces[piece];
        return {steps.data() + p.first_step, p.step_count};
    }
};

struct RootingOptions {
    int candidate_roots = 2;        ///< trees to make, from the most central roots
    double centrality_power = 1.0;  ///< weight of a point of the skeleton is radius to this power
    double root_blob_weight = 0.0;  ///< a root's own weight, as a multiple of its radius
};

}  // namespace ossuary
