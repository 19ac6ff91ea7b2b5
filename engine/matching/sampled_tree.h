#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "engine/matching/skeleton_descriptor.h"
#include "engine/matching/tree_shape.h"

namespace ossuary::matching {

/// A skeleton as trees of short pieces of equal length, so that a branch can be matched with part
/// of another. A node stands for one piece and hangs from the piece before it on the way from the
/// top; cycles are cut at the point as far from the top one way as the other.
struct SampledTree {
    struct Node {
        std::uint32_t branch = 0;
        std::uint32_t graph_node = kNoIndex;  ///< where the piece ends at one
        float length = 0.0F;                  ///< over the scale
        float log_radius = 0.0F;              ///< ln of the mean radius over the scale
        float turn = kUnknownTurn;  ///< angle to the piece before, in half turns; see below
    };
    /// A node of the graph with the pieces that begin there.
    struct Top {
        std::uint32_t graph_node = 0;
        std::vector<std::uint32_t> children;
        float length = 0.0F;  ///< of all that hangs below
    };
    /// Of the first pieces of branches: what they turn from depends on the top.
    static constexpr float kUnknownTurn = -1.0F;

    std::vector<Node> nodes;  ///< children before parents
    TreeShape shape;          ///< of `nodes`; a node may have several parents
    std::vector<Top> tops;
};

struct SampleTreeOptions {
    double step = 0.1;   ///< of a piece, over the scale
    double scale = 1.0;  ///< lengths and radii are taken times this
    /// Tops: false = the node in the middle of each component; true = every node of the heaviest
    /// component, subtrees that hang alike from several of them being there once.
    bool every_top = false;
};

/// Empty once asked to stop.
/// @pre the descriptor's matching data is derived
[[nodiscard]] SampledTree sample_tree(const SkeletonDescriptor& descriptor,
                                      const SampleTreeOptions& options = {},
                                      const std::stop_token& stop = {});

}  // namespace ossuary::matching
