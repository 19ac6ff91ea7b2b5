#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "engine/descriptor/global_descriptors.h"
#include "engine/matching/match_chain_codes.h"
#include "engine/matching/match_skeletons.h"
#include "engine/ranking/ranker.h"

namespace ossuary {

/// What `hybrid` fuses: component 0 is the skeleton, the others are the global descriptors in the
/// order of kGlobalDescriptorKinds.
inline constexpr std::size_t kComponentCount = 1 + kGlobalDescriptorKinds.size();
using ComponentValues = std::array<double, kComponentCount>;

[[nodiscard]] std::string_view component_name(std::size_t component);

/// Measures pairs of models; one for each thread, because it owns the matchers' buffers.
class PairMeter {
public:
    explicit PairMeter(const RankOptions& options) { skeleton_options_.pose = options.pose; }

    [[nodiscard]] double chain_code(const ModelDescriptor& a, const ModelDescriptor& b) {
        return chain_code_distance(a.skeleton, b.skeleton, chain_code_options_,
                                   chain_code_workspace_);
    }
    [[nodiscard]] double skeleton(const ModelDescriptor& a, const ModelDescriptor& b) {
        return skeleton_distance(a.skeleton, b.skeleton, skeleton_options_, skeleton_workspace_);
    }
    /// All components, each in its own unit.
    [[nodiscard]] ComponentValues components(const ModelDescriptor& a, const ModelDescriptor& b);

    [[nodiscard]] const SkeletonMatchOptions& skeleton_options() const { return skeleton_options_; }
    [[nodiscard]] const ChainCodeMatchOptions& chain_code_options() const {
        return chain_code_options_;
    }

private:
    ChainCodeMatchOptions chain_code_options_;
    SkeletonMatchOptions skeleton_options_;
    ChainCodeMatchWorkspace chain_code_workspace_;
    SkeletonMatchWorkspace skeleton_workspace_;
};

}  // namespace ossuary
