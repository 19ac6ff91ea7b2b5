#pragma once

#include "engine/core/result.h"
#include "engine/descriptor/model_descriptor.h"
#include "engine/matching/match.h"
#include "engine/ranking/normalization.h"
#include "engine/ranking/ranker.h"

namespace ossuary::ranking {

/// The distance of one pair with its parts and correspondences. For `hybrid` the parts are the
/// normalised shares of each descriptor, of build and of pose, for `skeleton` those of the tree
/// edit distance, of the pairs of points and of their layout, of build and of pose; the
/// correspondence is that of the tree edit distance. `rerank` is not a matter of one pair and is
/// ignored; a query that the normalisation does not know is judged by the pooled scale, so its
/// distance may differ a little from that of rank_distances. Errors: cancelled.
Result<matching::Match> explain(const descriptor::ModelDescriptor& query,
                                const descriptor::ModelDescriptor& other,
                                const Normalization& normalization,
                                const RankOptions& options = {});

}  // namespace ossuary::ranking
