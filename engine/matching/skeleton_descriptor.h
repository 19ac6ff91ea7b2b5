#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/skeleton/skeleton_graph.h"

namespace ossuary {

// First sketch; engine/matching owns this file and may reshape the fields. What must stay: it is a
// value type, made by describe_skeleton from a refined graph, compact (a few kilobytes), free of
// scale and position, and node / branch indices are those of the graph it was made from.
struct SkeletonDescriptor {
    struct Node {
        double significance = 0.0;
        double radius = 0.0;  ///< over the scale
    };
    struct Branch {
        std::uint32_t a = 0;
        std::uint32_t b = 0;
        std::string chain_code;     ///< 5-element code, '0'-'4', from the more significant node
        std::vector<float> points;  ///< x y z of the resampled branch over the scale, a → b
        std::vector<float> radii;   ///< over the scale, one a resampled point
        float length = 0.0F;        ///< over the scale
    };
    std::vector<Node> nodes;
    std::vector<Branch> branches;
};

struct DescribeSkeletonOptions {
    double sample_step = 0.05;  ///< resampling step over the scale
};

/// @param refined  in any unit
/// @param scale    square root of the model's surface area in the same unit, > 0
SkeletonDescriptor describe_skeleton(const SkeletonGraph& refined, double scale,
                                     const DescribeSkeletonOptions& options = {});

}  // namespace ossuary
