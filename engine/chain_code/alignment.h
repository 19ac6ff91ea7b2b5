#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "engine/chain_code/direction_code.h"

namespace ossuary {

struct AlignmentOptions {
    double direction_weight = 0.15;  ///< times min(1, 1 - cos of the angle between directions)
    double radius_weight = 0.7;      ///< times min(1, radius_gain * |r - r'| / (r + r'))
    double radius_gain = 3.0;
    double gap = 0.6;  ///< of a step without a partner
    bool operator==(const AlignmentOptions&) const = default;
};

/// The step costs of AlignmentOptions as tables.
class AlignmentCosts {
public:
    explicit AlignmentCosts(const AlignmentOptions& options = {});

    [[nodiscard]] float step(DirectionStep s, DirectionStep p) const {
        const int difference = static_cast<int>(s.radius_level) - static_cast<int>(p.radius_level);
        return direction_[s.direction][p.direction] +
               radius_[static_cast<std::size_t>(difference < 0 ? -difference : difference)];
    }
    [[nodiscard]] float gap() const { return gap_; }
    [[nodiscard]] const AlignmentOptions& options() const { return options_; }

private:
    AlignmentOptions options_;
    std::array<std::array<float, 32>, kDirectionCount> direction_{};
    std::array<float, 256> radius_{};
    float gap_ = 0.0F;
};

/// Codes longer than this are not aligned.
inline constexpr std::size_t kMaxAlignedSteps = 512;

/// The cost of the cheapest order-preserving alignment of two direction codes, a step of one with
/// one of the other or with a gap, over the length of the longer. Two empty codes cost 0. Symmetric
/// bit by bit. No allocation.
/// @pre both have at most kMaxAlignedSteps steps
[[nodiscard]] float alignment_cost(std::span<const DirectionStep> s,
                                   std::span<const DirectionStep> p, const AlignmentCosts& costs);

}  // namespace ossuary
