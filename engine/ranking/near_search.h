#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/core/result.h"
#include "engine/matching/match_part.h"
#include "engine/ranking/descriptor_source.h"
#include "engine/ranking/fusion.h"
#include "engine/ranking/normalization.h"
#include "engine/ranking/preselection.h"

namespace ossuary::ranking {

/// One query's distances to models of a collection, by sketches or the
/// ranker's own; what the stages of a search share. Models that are not there any more are taken
/// from the lists.
class NearSearch {
public:
    NearSearch(const descriptor::ModelDescriptor& query, DescriptorSource& collection,
               const Normalization& normalization, const RankOptions& options);

    /// Finds what the query is judged by, before anything else is asked. As rank_distances has it:
    /// its own scale where it is known, else by its distances to the references.
    /// @param exhaustive  the references are measured as everything else will be
    Result<void> judge_query(bool exhaustive);

    /// By sketches alone: about the ranker's distances without the tree edit distance, for which
    /// the pairs of the skeleton's points stand in.
    void sketch(std::vector<RankedModel>& models, const Preselection& preselection) const;
    /// The ranker's own distances. Fetches and measures by blocks, so that few descriptors are in
    /// use at a time.
    Result<void> measure(std::vector<RankedModel>& models);
    /// Re-ranks models that are sorted by distance.
    Result<void> rerank_models(std::vector<RankedModel>& models);

private:
    [[nodiscard]] double whole_distance(PairMeter& meter,
                                        const descriptor::ModelDescriptor& model) const;
    [[nodiscard]] FusionSide side_of(const descriptor::ModelDescriptor& model) const;
    Result<void> measure_parts(std::vector<RankedModel>& models);

    const descriptor::ModelDescriptor& query_;
    DescriptorSource& collection_;
    const Normalization& normalization_;
    const RankOptions options_;
    const RankOptions sketch_options_;
    FusionSide side_, sketch_side_;
};

}  // namespace ossuary::ranking
