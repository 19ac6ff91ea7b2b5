#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/descriptor/model_descriptor.h"

namespace ossuary::ranking {

enum class RankerKind {
    kHybrid,     ///< skeleton fused with global descriptors; the default
    kSkeleton,   ///< our best topology-matched, chain-code-ranked measure: skeletons alone
    kChainCode,  ///< the thesis to the letter, sec. 3.3
};

[[nodiscard]] std::string_view to_string(RankerKind ranker);  ///< hybrid, skeleton, chain-code
Result<RankerKind> parse_ranker(std::string_view name);
inline constexpr RankerKind kAllRankers[] = {RankerKind::kHybrid, RankerKind::kSkeleton,
                                             RankerKind::kChainCode};

inline constexpr double kDefaultPose = 0.15;

struct RankOptions {
    RankerKind ranker = RankerKind::kHybrid;
    /// In [0, 1]: 0 = build alone, 1 = pose alone, the default what tells kinds apart best. Between
    /// these the weights go over linearly. `chain-code` knows no pose.
    double pose = kDefaultPose;
    bool rerank = false;  ///< unsupervised re-ranking over the collection
    /// The query is looked for as a part of each model (match_part.h), by skeletons alone, whatever
    /// the ranker; not together with `rerank`.
    bool part = false;
    int jobs = 1;
    std::stop_token stop =
        {};  ///< looked at every few milliseconds; then the outcome is `cancelled`
    /// In [0, 1]: how far the size in the file's unit counts; 0 = not at all. `chain-code` and
    /// parts know no size.
    double size = 0.0;
};

/// What normalisation needs to know of a collection; made once for an index and stored with it.
/// `values` is opaque to everyone but the rankers and versioned by its first element.
struct CollectionStatistics {
    std::vector<double> values;
};

/// Square matrix of distances, row by row: at(i, j) = distance of model j to query i.
struct DistanceMatrix {
    std::size_t size = 0;
    std::vector<float> values;
    [[nodiscard]] float at(std::size_t i, std::size_t j) const { return values[i * size + j]; }
};

using DescriptorSpan = std::span<const descriptor::ModelDescriptor* const>;

/// The collection's own distance statistics: for each component and each model the mean
/// and deviation of its distances to at most 500 models (fewer in collections above 2,000, so that
/// a million pairs are measured at most; above 20,000 pooled over all models only). A function of
/// the collection and its order. No class label is used. Models are known again by their content,
/// so the statistics serve any subset of the collection in any order. Errors: cancelled.
Result<CollectionStatistics> collection_statistics(DescriptorSpan collection, int jobs = 1,
                                                   const std::stop_token& stop = {});

/// Distances from a query (in the collection or not) to each model of the collection, as long as
/// `collection`; the same, bit by bit, for every number of jobs. Zero for an equal model. With
/// `rerank` in [0, 2]: the nearest 200 change places among themselves, the others follow.
/// A query that the statistics do not know is judged by its distances to at most 500 models of the
/// collection when that is at least half of what the statistics are of, else by the pooled scale.
/// Errors: cancelled.
Result<std::vector<double>> rank_distances(const descriptor::ModelDescriptor& query,
                                           DescriptorSpan collection,
                                           const CollectionStatistics& statistics,
                                           const RankOptions& options = {});

/// All pairs at once, what `evaluate` uses; row i equals rank_distances of model i.
/// Errors: cancelled.
/// @pre not `part`
Result<DistanceMatrix> distance_matrix(DescriptorSpan collection,
                                       const CollectionStatistics& statistics,
                                       const RankOptions& options = {});

}  // namespace ossuary::ranking
