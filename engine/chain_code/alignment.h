#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "engine/chain_code/direction_code.h"

namespace ossuary::chain_code {

struct AlignmentOptions {
    double direction_weight = 0.15;  ///< times min(1, 1 - cos of the angle between directions)
    double radius_weight = 0.7;      ///< times min(1, radius_gain / 2 * |ln r - ln r'|), which is
                                     ///< nearly radius_gain * |r - r'| / (r + r')
    double radius_gain = 3.0;
    double gap = 0.6;  ///< of a step without a partner, > 0
    bool operator==(const AlignmentOptions&) const = default;
};

/// Codes longer than this are not aligned.
inline constexpr std::size_t kMaxAlignedSteps = 96;

/// The step costs of AlignmentOptions in whole units, small enough that the cost of any alignment
/// of two codes fits 16 bits: eight alignments run side by side in one vector register.
class AlignmentCosts {
public:
    explicit AlignmentCosts(const AlignmentOptions& options = {});

    [[nodiscard]] int direction(std::uint8_t s, std::uint8_t p) const { return direction_[s][p]; }
    [[nodiscard]] int radius(int level_difference) const {
        const int distance = level_difference < 0 ? -level_difference : level_difference;
        return distance < radius_limit_levels_ ? radius_slope_ * distance : radius_limit_;
    }
    [[nodiscard]] int step(DirectionStep s, DirectionStep p) const {
        return direction(s.direction, p.direction) +
               radius(static_cast<int>(s.radius_level) - static_cast<int>(p.radius_level));
    }
    [[nodiscard]] int gap() const { return gap_; }
    [[nodiscard]] int radius_slope() const { return radius_slope_; }
    /// Level differences from here on all cost `radius_limit`.
    [[nodiscard]] int radius_limit_levels() const { return radius_limit_levels_; }
    [[nodiscard]] int radius_limit() const { return radius_limit_; }
    /// Units in a cost of 1.
    [[nodiscard]] double unit() const { return unit_; }
    [[nodiscard]] const AlignmentOptions& options() const { return options_; }

private:
    AlignmentOptions options_;
    double unit_ = 1.0;
    std::array<std::array<std::int16_t, 32>, kDirectionCount> direction_{};
    int radius_slope_ = 0;
    int radius_limit_levels_ = 0;
    int radius_limit_ = 0;
    int gap_ = 0;
};

/// The cost of the cheapest order-preserving alignment of two direction codes, a step of one with
/// one of the other or with a gap, over the length of the longer. Two empty codes cost 0.
/// Symmetric.
/// @pre both have at most kMaxAlignedSteps steps
[[nodiscard]] float alignment_cost(std::span<const DirectionStep> s,
                                   std::span<const DirectionStep> p, const AlignmentCosts& costs);

}  // namespace ossuary::chain_code
