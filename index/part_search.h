#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/core/result.h"
#include "engine/descriptor/model_descriptor.h"
#include "engine/matching/match.h"
#include "engine/ranking/ranker.h"
#include "engine/registration/piece_search.h"
#include "index/snapshot.h"
#include "index/store.h"

namespace ossuary::index {

/// What a part is looked for by.
struct PartQuery {
    const descriptor::ModelDescriptor& descriptor;
    const registration::PieceQuery& piece;
};

/// A model as one that may have the part.
struct PartFit {
    double distance = 1.0;  ///< in [0, 1], what hits are sorted by
    double skeleton = 1.0;  ///< of matching the skeletons (part_search.h of ranking)
    double features = 1.0;  ///< 1 - piece_likeness
    /// What of the distance is placement's, features' and skeleton's.
    std::vector<matching::DistancePart> shares;
    std::optional<registration::PiecePlacement> placement;  ///< only of the most alike
};

struct PartFits {
    std::vector<PartFit> fits;  ///< of each of the snapshot's models
    std::size_t without_features = 0;  ///< models of which only the skeleton is known
};

/// How far each model is from having the part. By local features of its surface, blind to size and
/// place, models are put in order; in the `kPartsPlaced` most alike the part is laid where it fits
/// best, and what lies in its place comes first. Limbs that are bent lie nowhere, but are alike.
/// @param among  positions that may be hits, ascending; empty = all
/// Errors: cancelled, and those of the store.
Result<PartFits> part_fits(Store& store, const Snapshot& snapshot, const PartQuery& query,
                           const ranking::RankOptions& options,
                           const std::vector<std::uint32_t>& among);

inline constexpr std::size_t kPartsPlaced = 120;

}  // namespace ossuary::index
