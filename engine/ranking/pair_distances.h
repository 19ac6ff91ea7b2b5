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

/// What is fused: component 0 is the tree edit distance of the skeletons, the others are the global
/// descriptors in the order of kGlobalDescriptorKinds. `skeleton` fuses the first three alone.
inline constexpr std::size_t kComponentCount = 1 + descriptor::kGlobalDescriptorKinds.size();
using ComponentValues = std::array<double, kComponentCount>;
inline constexpr std::size_t kSkeletonComponents = 3;
/// How many components, from the first, a ranker fuses; 0 for one that fuses nothing.
[[nodiscard]] constexpr std::size_t component_count(RankerKind ranker) {
    switch (ranker) {
        case RankerKind::kHybrid:
            return kComponentCount;
        case RankerKind::kSkeleton:
            return kSkeletonComponents;
        case RankerKind::kChainCode:
            return 0;
    }
    return 0;
}

/// How far what bending changes counts: 1 from the default of RankOptions::pose on.
[[nodiscard]] inline double pose_share(const RankOptions& options) {
    return std::min(options.pose / kDefaultPose, 1.0);
}

[[nodiscard]] std::string_view component_name(std::size_t component);

/// Measures pairs of models; one for each thread, because it owns the matchers' buffers. Once the
/// options' `stop` asks, it returns soon, and what it returns means nothing.
class PairMeter {
public:
    explicit PairMeter(const RankOptions& options)
        : components_(component_count(options.ranker)),
          pose_share_(pose_share(options)),
          stop_(options.stop),
          chain_code_workspace_(stop_),
          skeleton_workspace_(stop_) {
        skeleton_options_.pose = options.pose;
    }

    [[nodiscard]] double chain_code(const descriptor::ModelDescriptor& a,
                                    const descriptor::ModelDescriptor& b) {
        return matching::chain_code_distance(a.skeleton, b.skeleton, chain_code_options_,
                                             chain_code_workspace_);
    }
    /// The tree edit distance and, beyond the default `pose`, how differently the two stand.
    [[nodiscard]] double skeleton(const descriptor::ModelDescriptor& a,
                                  const descriptor::ModelDescriptor& b);
    /// Of pose_distance beside the tree edit distance: none up to the default `pose`, because it
    /// says nothing of the class and costs as much as the tree edit distance.
    [[nodiscard]] double pose_weight() const;
    /// The components that the ranker fuses, each in its own unit; 0 for the others.
    [[nodiscard]] ComponentValues components(const descriptor::ModelDescriptor& a,
                                             const descriptor::ModelDescriptor& b);
    /// The same without the first, which costs twenty times the others together: 0 in its place.
    [[nodiscard]] ComponentValues global_components(const descriptor::ModelDescriptor& a,
                                                    const descriptor::ModelDescriptor& b) const;

    [[nodiscard]] const matching::SkeletonMatchOptions& skeleton_options() const {
        return skeleton_options_;
    }
    [[nodiscard]] const matching::ChainCodeMatchOptions& chain_code_options() const {
        return chain_code_options_;
    }

private:
    std::size_t components_;
    double pose_share_;
    std::stop_token stop_;
    matching::ChainCodeMatchOptions chain_code_options_;
    matching::SkeletonMatchOptions skeleton_options_;
    matching::ChainCodeMatchWorkspace chain_code_workspace_;
    matching::SkeletonMatchWorkspace skeleton_workspace_;
};

}  // namespace ossuary::ranking
