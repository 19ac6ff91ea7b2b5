#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "engine/ranking/ranker.h"

namespace ossuary::ranking {

/// How well models of one label find each other when those that are alike in another way are left
/// out: the same pose among other bodies, or the same body in other poses.
struct AmongOthers {
    double nearest_neighbor = 0.0;  ///< share of queries whose nearest is of their label
    double first_tier = 0.0;        ///< share of the n of a label that are among the first n
    std::size_t queries = 0;        ///< models with anything to find
};

/// @param labels  what is looked for; models with an empty one are no queries and never right
/// @param others  as long: each query's list is without the models that share this with it, where
///                it is not empty
/// Ties in distance are broken by index; what is not a number comes last.
[[nodiscard]] AmongOthers among_others(const DistanceMatrix& distances,
                                       std::span<const std::string> labels,
                                       std::span<const std::string> others);

}  // namespace ossuary::ranking
