#include "engine/ranking/explain.h"

#include <string>
#include <utility>

#include "engine/ranking/cancelled.h"
#include "engine/ranking/fusion.h"
#include "engine/ranking/pair_distances.h"
#include "engine/ranking/part_search.h"

namespace ossuary::ranking {
namespace {

/// The tree edit distance's share of a fused distance, in the proportion of its own parts.
std::vector<matching::DistancePart> split(double share, const matching::Match& match) {
    std::vector<matching::DistancePart> parts = match.parts;
    for (matching::DistancePart& part : parts) {
        part.value *= match.distance > 0.0 ? share / match.distance : 0.0;
    }
    return parts;
}

matching::Match explain_whole(const descriptor::ModelDescriptor& query,
                              const descriptor::ModelDescriptor& other,
                              const Normalization& normalization, const RankOptions& options) {
    PairMeter meter(options);
    if (options.ranker == RankerKind::kChainCode) {
        return matching::match_chain_codes(query.skeleton, other.skeleton,
                                           meter.chain_code_options(), options.stop);
    }
    matching::Match match = matching::match_skeletons(query.skeleton, other.skeleton,
                                                      meter.skeleton_options(), options.stop);
    const FusionSide a = fusion_side(query, normalization.scale(query), options);
    const FusionSide b = fusion_side(other, normalization.scale(other), options);
    const ComponentValues distances = meter.components(query, other);
    const ComponentValues parts = fused_parts(distances, a, b);
    std::vector<matching::DistancePart> named;
    if (options.ranker == RankerKind::kSkeleton) named = split(parts[0], match);
    for (std::size_t c = named.size() > 0 ? 1 : 0; c < kComponentCount; ++c) {
        if (!fuses(options.ranker, c) || (c == kSizeComponent && options.size <= 0.0)) continue;
        named.push_back({std::string(component_name(c)), parts[c]});
    }
    match.parts = std::move(named);
    match.distance = fused_distance(distances, a, b);
    const auto over_mean = [&](double distance, std::size_t component) {
        return distance * (0.5 / a.scale.mean[component] + 0.5 / b.scale.mean[component]);
    };
    match.build = over_mean(build_distance(query, other), kBuildComponent);
    match.pose = over_mean(pose_distance(query, other), kPoseComponent);
    return match;
}

}  // namespace

Result<matching::Match> explain(const descriptor::ModelDescriptor& query,
                                const descriptor::ModelDescriptor& other,
                                const Normalization& normalization, const RankOptions& options) {
    if (options.part) return explain_part(query, other, options);
    matching::Match match = explain_whole(query, other, normalization, options);
    if (options.stop.stop_requested()) return cancelled();
    return match;
}

}  // namespace ossuary::ranking
