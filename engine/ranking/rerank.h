#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace ossuary::ranking {

struct RerankOptions {
    std::size_t depth = 200;       ///< models at the head of a ranked list that take part
    std::size_t neighbors = 15;    ///< k of the reciprocal neighbourhoods
    std::size_t expansion = 6;     ///< neighbours that a neighbourhood is averaged over
    double original_weight = 0.2;  ///< of the distance itself beside the neighbourhoods'
};

/// The distances of model i of the collection to each of `others`; called from several threads.
using CollectionDistances =
    std::function<std::vector<double>(std::size_t i, std::span<const std::size_t> others)>;

/// Re-ranks a list by how much the query's neighbourhood and each model's overlap: the Jaccard
/// distance of their k-reciprocal neighbourhoods (Zhong, Zheng, Cao and Li, "Re-ranking person
/// re-identification with k-reciprocal encoding", CVPR 2017, sec. 3). It looks at the collection
/// only, never at labels. The first `depth` models change places among themselves; the others
/// follow in their old order, so that none is lost.
/// @param distances   from the query to every model of the collection
/// @param collection  symmetric; asked for pairs among the first `depth` models
/// @return            new distances in [0, 2], as long as `distances`
std::vector<double> rerank(const std::vector<double>& distances,
                           const CollectionDistances& collection, const RerankOptions& options = {},
                           int jobs = 1);

}  // namespace ossuary::ranking
