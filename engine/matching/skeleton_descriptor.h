#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/matching/rooted_skeleton.h"
#include "engine/matching/topological_signature.h"
#include "engine/skeleton/skeleton_graph.h"

namespace ossuary::matching {

/// All that the rankers `chain-code` and `skeleton` need of a model's skeleton: free of scale and
/// position, a few kilobytes. Node and branch indices are those of the graph it was made from.
///
/// `rooted` and `hierarchy` follow from the rest alone, bit by bit, so a store leaves them out and
/// calls `derive_matching_data` after loading.
struct SkeletonDescriptor {
    struct Node {
        std::array<float, 3> position{};  ///< from the skeleton's centre, over the scale
        float radius = 0.0F;              ///< over the scale
        float significance = 0.0F;        ///< eq. 3.3, as a share of the sum over all nodes
    };
    struct Branch {
        std::uint32_t a = 0;
        std::uint32_t b = 0;        ///< equals `a` for a loop through one node
        std::string chain_code;     ///< 5-element code, '0'-'4', from the more significant node
        std::vector<float> points;  ///< x y z of the resampled branch like Node::position, a → b
        std::vector<float> radii;   ///< over the scale, one a resampled point
        // Both are whole multiples of kPointUnit and kRadiusUnit where describe_skeleton made them.
        float length = 0.0F;  ///< over the scale, of the refined branch
    };
    std::vector<Node> nodes;
    std::vector<Branch> branches;
    float solid_volume = 0.0F;  ///< of the model, over the scale cubed; at most .057, a ball's
    float limb_volume = 0.0F;   ///< of tubes of the inscribed radii along the branches, likewise

    RootedSkeletons rooted;   ///< derived; for `skeleton`
    SignatureTree hierarchy;  ///< derived; for `chain-code`
};

/// Samples are rounded to these units, a two-hundredth of the step between them, so that a store
/// can keep 8 bytes a sample.
inline constexpr float kPointUnit = 1.0F / 4096.0F;
inline constexpr float kRadiusUnit = 1.0F / 65536.0F;

struct DescribeSkeletonOptions {
    double sample_step = 0.05;  ///< resampling step over the scale
    int max_samples = 97;       ///< of one branch; longer branches get a longer step
};

/// @param refined  in VOXEL units of a grid whose longest side is the indexing resolution: the
///                 5-element codes are read off that grid's lattice
/// @param scale    the length to measure in (body_scale), in voxels too, > 0
/// Leaves the volumes to the caller, who has the solid.
SkeletonDescriptor describe_skeleton(const skeleton::SkeletonGraph& refined, double scale,
                                     const DescribeSkeletonOptions& options = {});

/// The same without chain codes and derived data: where the skeleton lies and how thick it is.
SkeletonDescriptor trace_skeleton(const skeleton::SkeletonGraph& refined, double scale,
                                  const DescribeSkeletonOptions& options = {});

/// Recomputes `rooted` and `hierarchy` from `nodes` and `branches`; what a store calls after
/// loading.
/// @pre every branch end is an index into `nodes`, `points` holds three floats a radius and at
/// least
///      two points
void derive_matching_data(SkeletonDescriptor& descriptor, const RootingOptions& options = {});

}  // namespace ossuary::matching
