#pragma once

#include <memory>
#include <stop_token>

#include "engine/matching/match.h"
#include "engine/matching/skeleton_descriptor.h"

namespace ossuary::matching {

/// Parameters of the ranker `chain-code`.
struct ChainCodeMatchOptions {
    double significance_weight = 1.0;  ///< of the nodes' significance beside the signatures
    /// A literal sum over branches (sec. 3.3.2) cannot give the range of Table 4.2; the mean can.
    bool sum = false;
    bool operator==(const ChainCodeMatchOptions&) const = default;
};

/// What distance computations reuse between pairs; one for each thread. Once asked to stop, they
/// return soon, and what they return means nothing.
class ChainCodeMatchWorkspace {
public:
    explicit ChainCodeMatchWorkspace(std::stop_token stop = {});
    ~ChainCodeMatchWorkspace();
    ChainCodeMatchWorkspace(ChainCodeMatchWorkspace&&) noexcept;
    ChainCodeMatchWorkspace& operator=(ChainCodeMatchWorkspace&&) noexcept;

    struct Buffers;
    [[nodiscard]] Buffers& buffers() { return *buffers_; }

private:
    std::unique_ptr<Buffers> buffers_;
};

/// The thesis' measure (sec. 3.3): non-terminal nodes matched greedily and depth first by their
/// topological signature vectors and significance, end points below matched nodes by subtree edit
/// distance, then the stretch/twist distance (eq. 3.6) over the branches whose ends are matched,
/// 1 for each branch without a partner, and the mean.
/// Zero for equal skeletons, symmetric bit by bit, in [0, 1] (with `sum`: up to the number of
/// branches of both). Means nothing once asked to stop.
[[nodiscard]] Match match_chain_codes(const SkeletonDescriptor& a, const SkeletonDescriptor& b,
                                      const ChainCodeMatchOptions& options = {},
                                      const std::stop_token& stop = {});

/// The distance of match_chain_codes alone, bit by bit.
[[nodiscard]] double chain_code_distance(const SkeletonDescriptor& a, const SkeletonDescriptor& b,
                                         const ChainCodeMatchOptions& options,
                                         ChainCodeMatchWorkspace& workspace);

}  // namespace ossuary::matching
