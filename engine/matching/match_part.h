#pragma once

#include <cstddef>
#include <cstdint>
#include <stop_token>
#include <utility>
#include <vector>

#include "engine/matching/match.h"
#include "engine/matching/part_edit.h"
#include "engine/matching/sampled_tree.h"

namespace ossuary::matching {

/// Parameters of matching a part.
struct PartMatchOptions {
    PartEditCosts costs;
    double step = 0.1;  ///< of the pieces that skeletons are cut into, over the whole's scale
    /// How large the part may be beside the whole, over its scale: candidates from `largest` down,
    /// each `ratio` times the one before.
    double largest = 1.0;
    double ratio = 0.86;
    int candidates = 11;
    /// Added to the distance for each halving of the part: small copies of it fit everywhere.
    double shrinking = 0.05;
};

/// A query's skeleton as a part to look for, at every candidate size; made once for a search.
class PartQuery {
public:
    /// Once asked to stop, it has fewer candidates than it should.
    /// @pre the descriptor's matching data is derived
    explicit PartQuery(const SkeletonDescriptor& part, const PartMatchOptions& options = {},
                       const std::stop_token& stop = {});

    struct Candidate {
        double scale = 1.0;
        SampledTree tree;
        double length = 0.0;  ///< of the whole part
    };
    [[nodiscard]] const std::vector<Candidate>& candidates() const { return candidates_; }
    [[nodiscard]] const PartMatchOptions& options() const { return options_; }
    [[nodiscard]] bool empty() const { return candidates_.empty(); }
    [[nodiscard]] std::size_t node_count() const { return node_count_; }
    /// The nodes that each branch of the part joins.
    [[nodiscard]] const std::vector<std::pair<std::uint32_t, std::uint32_t>>& branches() const {
        return branches_;
    }

private:
    PartMatchOptions options_;
    std::vector<Candidate> candidates_;
    std::size_t node_count_ = 0;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> branches_;
};

/// How far a model is from having the part somewhere, in [0, 1]: the cheapest edit (part_edit.h) of
/// the part, at the size that suits best, to a connected piece of the model's skeleton, as a share
/// of what removing the whole part costs (partial matching, thesis sec. 3.3.1). 0 where a skeleton
/// contains the part at a candidate size, 1 for a model without a skeleton; 0 for a part without.
/// Not symmetric. Free of scale, position, rotation and mirroring. Means nothing where the
/// workspace was asked to stop.
[[nodiscard]] double part_distance(const PartQuery& part, const SkeletonDescriptor& whole,
                                   PartEdit& workspace);

/// The same with its parts (exchanged, size, unmatched) and the correspondence: a = the part's
/// nodes and branches, b = the whole's. A branch may be matched with several, of each of which it
/// is like a stretch. Means nothing once asked to stop.
[[nodiscard]] Match match_part(const PartQuery& part, const SkeletonDescriptor& whole,
                               const std::stop_token& stop = {});

}  // namespace ossuary::matching
