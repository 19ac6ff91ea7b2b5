#pragma once

#include <vector>

#include "engine/matching/match.h"
#include "engine/ranking/ranker.h"

namespace ossuary::ranking {

/// How far each model of a collection is from having the query's skeleton as a part of its own
/// (match_part.h), in [0, 1]; the same, bit by bit, for every number of jobs. No model is left out
/// by a preselection: a part says nothing of the whole's signature. Reads `pose`, `jobs` and `stop`
/// of the options. Errors: cancelled.
Result<std::vector<double>> part_distances(const descriptor::ModelDescriptor& part,
                                           DescriptorSpan collection,
                                           const RankOptions& options = {});

/// The distance of one model with its parts and correspondences: a = the query's, b = the model's.
/// Errors: cancelled.
Result<matching::Match> explain_part(const descriptor::ModelDescriptor& part,
                                     const descriptor::ModelDescriptor& whole,
                                     const RankOptions& options = {});

}  // namespace ossuary::ranking
