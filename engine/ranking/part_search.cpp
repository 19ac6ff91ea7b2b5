#include "engine/ranking/part_search.h"

#include <algorithm>

#include "engine/core/parallel.h"
#include "engine/matching/match_part.h"
#include "engine/ranking/cancelled.h"

namespace ossuary {
inline namespace ranking {
namespace {

constexpr std::size_t kBlock = 16;

PartQuery part_query(const ModelDescriptor& part, const RankOptions& options) {
    PartMatchOptions match;
    match.costs.turn_weight = options.pose;
    return PartQuery(part.skeleton, match, options.stop);
}

}  // namespace

Result<std::vector<double>> part_distances(const ModelDescriptor& part, DescriptorSpan collection,
                                           const RankOptions& options) {
    const PartQuery query = part_query(part, options);
    std::vector<double> distances(collection.size());
    parallel_for((collection.size() + kBlock - 1) / kBlock, options.jobs, [&](std::size_t block) {
        PartEdit workspace(options.stop);
        const std::size_t end = std::min(collection.size(), (block + 1) * kBlock);
        for (std::size_t i = block * kBlock; i < end && !options.stop.stop_requested(); ++i) {
            distances[i] = part_distance(query, collection[i]->skeleton, workspace);
        }
    });
    if (options.stop.stop_requested()) return cancelled();
    return distances;
}

Result<Match> explain_part(const ModelDescriptor& part, const ModelDescriptor& whole,
                           const RankOptions& options) {
    Match match = match_part(part_query(part, options), whole.skeleton, options.stop);
    if (options.stop.stop_requested()) return cancelled();
    return match;
}

}  // namespace ranking
}  // namespace ossuary
