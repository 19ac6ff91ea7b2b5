#pragma once

#include <memory>
#include <stop_token>

#include "engine/chain_code/alignment.h"
#include "engine/matching/match.h"
#include "engine/matching/skeleton_descriptor.h"

namespace ossuary::matching {

/// Parameters of the ranker `skeleton`.
struct SkeletonMatchOptions {
    double pose = 0.15;  ///< in [0, 1]: weight of direction beside build; 0 = build only
    double radius_weight = 0.7;
    double radius_gain = 2.5;
    double gap = 0.6;
    double length_weight = 0.3;  ///< times |l - l'| / (l + l')
    double deletion = 0.6;       ///< of a piece without a partner, times its length
    bool operator==(const SkeletonMatchOptions&) const = default;
};

/// What distance computations reuse between pairs; one for each thread, for any options. Once asked
/// to stop, they return soon, and what they return means nothing.
class SkeletonMatchWorkspace {
public:
    explicit SkeletonMatchWorkspace(std::stop_token stop = {});
    ~SkeletonMatchWorkspace();
    SkeletonMatchWorkspace(SkeletonMatchWorkspace&&) noexcept;
    SkeletonMatchWorkspace& operator=(SkeletonMatchWorkspace&&) noexcept;

    struct Buffers;
    [[nodiscard]] Buffers& buffers() { return *buffers_; }

private:
    std::unique_ptr<Buffers> buffers_;
};

/// How unlike two skeletons are: both are hung up at each of their candidate roots, and the
/// cheapest constrained unordered tree edit distance (Zhang, "A constrained edit distance between
/// unordered labeled trees", Algorithmica 15, 1996) over the pairings of roots counts, divided by
/// the total weight. A piece of branch is exchanged for another at the cost of aligning their
/// direction codes plus the difference of their lengths, weighted by both lengths.
///
/// Zero for equal skeletons, symmetric bit by bit, at most `deletion`. Free of scale and position,
/// of rotation and mirroring, of numbering and direction of branches. The correspondence comes from
/// backtracking; the two halves of a cut cycle are one branch. Parts: code, length, unmatched.
/// Means nothing once asked to stop.
[[nodiscard]] Match match_skeletons(const SkeletonDescriptor& a, const SkeletonDescriptor& b,
                                    const SkeletonMatchOptions& options = {},
                                    const std::stop_token& stop = {});

/// The distance of match_skeletons alone, bit by bit; allocates nothing once `workspace` is warm.
[[nodiscard]] double skeleton_distance(const SkeletonDescriptor& a, const SkeletonDescriptor& b,
                                       const SkeletonMatchOptions& options,
                                       SkeletonMatchWorkspace& workspace);

}  // namespace ossuary::matching
