#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/core/result.h"
#include "engine/matching/match.h"
#include "engine/registration/piece_search.h"
#include "index/find_hits.h"
#include "index/store.h"

// Private to the searcher: what has the query as a part.

namespace ossuary::index {

/// A model as one that may have the part.
struct PartFit {
    double features = 1.0;  ///< 1 - piece_likeness
    double skeleton =
        1.0;  ///< of matching the skeletons (part_search.h of ranking), where measured
    std::optional<registration::PiecePlacement> placement;  ///< only of the most alike
    bool settled = false;                                   ///< by settle_piece

    /// What of the distance is placement's, features' and skeleton's. What lies in its place comes
    /// first, by how well; then what is alike.
    [[nodiscard]] std::vector<matching::DistancePart> shares() const;
    /// In [0, 1], what hits are sorted by.
    [[nodiscard]] double distance() const;
};

struct PartFits {
    std::vector<PartFit> fits;         ///< of each of the snapshot's models
    std::size_t without_features = 0;  ///< models of which only the skeleton is known
    bool complete = true;              ///< no model has changed since the snapshot
};

struct PartSearchOptions {
    std::size_t placed = 60;          ///< models that the part is laid into, the most alike
    std::size_t placed_of_few = 200;  ///< the same in collections of at most `all_skeletons`
    std::size_t settled = 16;         ///< of these, those that are looked at more closely
    /// Models whose skeletons are matched, the most alike, in collections of more than
    /// `all_skeletons`; those without features always are.
    std::size_t skeletons = 100;
    std::size_t all_skeletons = 2000;
};

/// How far each model is from having the part. By local features of its surface, blind to size and
/// place, models are put in order; in the most alike the part is laid where it fits best, and what
/// lies in its place comes first. Limbs that are bent lie nowhere, but are alike. The same for
/// every number of jobs.
/// @param among  positions that may be hits, ascending; null = all
/// @pre question.piece
/// Errors: cancelled, and those of the store.
Result<PartFits> part_fits(const Question& question, Store& store,
                           const std::vector<std::uint32_t>* among,
                           const PartSearchOptions& options = {});

}  // namespace ossuary::index
