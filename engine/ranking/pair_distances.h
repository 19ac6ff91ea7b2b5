#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <stop_token>
#include <string_view>

#include "engine/descriptor/global_descriptors.h"
#include "engine/matching/match_chain_codes.h"
#include "engine/matching/match_skeletons.h"
#include "engine/ranking/ranker.h"

namespace ossuary::ranking {

/// What is fused: component 0 is the tree edit distance of the skeletons, then come the global
/// descriptors that tell kinds apart, in the order of kGlobalDescriptorKinds, of which `skeleton`
/// fuses the first two alone; then the two measures that `--pose` goes between; last the size.
inline constexpr std::size_t kBuildComponent = 1 + descriptor::kThicknessPlace;
inline constexpr std::size_t kPoseComponent = kBuildComponent + 1;
inline constexpr std::size_t kSizeComponent = kPoseComponent + 1;
inline constexpr std::size_t kComponentCount = kSizeComponent + 1;
using ComponentValues = std::array<double, kComponentCount>;
inline constexpr std::size_t kSkeletonComponents = 3;
/// Whether a ranker fuses a component; `chain-code` fuses none.
[[nodiscard]] constexpr bool fuses(RankerKind ranker, std::size_t component) {
    if (ranker == RankerKind::kChainCode) return false;
    return ranker == RankerKind::kHybrid || component < kSkeletonComponents ||
           component >= kBuildComponent;
}

/// @pre component < kComponentCount
[[nodiscard]] constexpr std::string_view component_name(std::size_t component) {
    if (component == kBuildComponent) return "build";
    if (component == kPoseComponent) return "pose";
    if (component == kSizeComponent) return "size";
    return component == 0 ? "skeleton" : descriptor::kGlobalDescriptorKinds[component - 1].name;
}

/// How unlike two bodies are built, whatever their limbs do: their thicknesses, the pairs of them
/// along the surface, and the pairs of points along the skeleton, in one number. 0 for equal ones,
/// symmetric bit by bit.
[[nodiscard]] double build_distance(const descriptor::ModelDescriptor& a,
                                    const descriptor::ModelDescriptor& b);

/// The same from the three distances that it is made of.
[[nodiscard]] double build_of(double thickness, double thickness_pairs, double skeleton_pairs);

/// How differently two bodies stand, whatever they are: descriptor::pose_points_distance.
[[nodiscard]] double pose_distance(const descriptor::ModelDescriptor& a,
                                   const descriptor::ModelDescriptor& b);

/// Measures pairs of models; one for each thread, because it owns the matchers' buffers. Once the
/// options' `stop` asks, it returns soon, and what it returns means nothing.
class PairMeter {
public:
    explicit PairMeter(const RankOptions& options)
        : ranker_(options.ranker),
          pose_(options.pose),
          size_(options.size),
          stop_(options.stop),
          chain_code_workspace_(stop_),
          skeleton_workspace_(stop_) {}

    [[nodiscard]] double chain_code(const descriptor::ModelDescriptor& a,
                                    const descriptor::ModelDescriptor& b) {
        return matching::chain_code_distance(a.skeleton, b.skeleton, chain_code_options_,
                                             chain_code_workspace_);
    }
    /// The components that the ranker fuses, each in its own unit; 0 for the others, and for those
    /// that have no weight at the options' `pose` and `size`.
    [[nodiscard]] ComponentValues components(const descriptor::ModelDescriptor& a,
                                             const descriptor::ModelDescriptor& b);
    /// The same without the tree edit distance and the pose, which cost twenty and two hundred
    /// times the others together: 0 in their places.
    [[nodiscard]] ComponentValues cheap_components(const descriptor::ModelDescriptor& a,
                                                   const descriptor::ModelDescriptor& b) const;

    [[nodiscard]] const matching::SkeletonMatchOptions& skeleton_options() const {
        return skeleton_options_;
    }
    [[nodiscard]] const matching::ChainCodeMatchOptions& chain_code_options() const {
        return chain_code_options_;
    }

private:
    RankerKind ranker_;
    double pose_;
    double size_;
    std::stop_token stop_;
    matching::ChainCodeMatchOptions chain_code_options_;
    matching::SkeletonMatchOptions skeleton_options_;
    matching::ChainCodeMatchWorkspace chain_code_workspace_;
    matching::SkeletonMatchWorkspace skeleton_workspace_;
};

}  // namespace ossuary::ranking
