#include "engine/ranking/part_search.h"

#include <algorithm>

#include "engine/core/parallel.h"
#include "engine/matching/match_part.h"
#include "engine/ranking/cancelled.h"

namespace ossuary::ranking {
namespace {

constexpr std::size_t kBlock = 16;

matching::PartQuery part_query(const descriptor::ModelDescriptor& part,
                               const RankOptions& options) {
    matching::PartMatchOptions match;
    match.costs.turn_weight = options.pose;
    return matching::PartQuery(part.skeleton, match, options.stop);
}

}  // namespace

Result<std::vector<double>> part_distances(const descriptor::ModelDescriptor& part,
                                           DescriptorSpan collection, const RankOptions& options) {
    const matching::PartQuery query = part_query(part, options);
    std::vector<double> distances(collection.size());
    parallel_for((collection.size() + kBlock - 1) / kBlock, options.jobs, [&](std::size_t block) {
        matching::PartEdit workspace(options.stop);
        const std::size_t end = std::min(collection.size(), (block + 1) * kBlock);
        for (std::size_t i = block * kBlock; i < end && !options.stop.stop_requested(); ++i) {
            distances[i] = matching::part_distance(query, collection[i]->skeleton, workspace);
        }
    });
    if (options.stop.stop_requested()) return cancelled();
    return distances;
}

Result<matching::Match> explain_part(const descriptor::ModelDescriptor& part,
                                     const descriptor::ModelDescriptor& whole,
                                     const RankOptions& options) {
    matching::Match match =
        matching::match_part(part_query(part, options), whole.skeleton, options.stop);
    if (options.stop.stop_requested()) return cancelled();
    return match;
}

}  // namespace ossuary::ranking
