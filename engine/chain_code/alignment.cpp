#include "engine/chain_code/alignment.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace ossuary::chain_code {
namespace {

constexpr double kLargestPathCost = 32000.0;  // leaves room for one more step in 16 bits
constexpr double kFinestUnit = 512.0;

}  // namespace

AlignmentCosts::AlignmentCosts(const AlignmentOptions& options) : options_(options) {
    assert(options.gap > 0.0);
    // No alignment costs more than gaps alone.
    const double most_gaps = 2.0 * static_cast<double>(kMaxAlignedSteps) * options.gap;
    unit_ = std::min(kFinestUnit, std::floor(kLargestPathCost / most_gaps));
    const auto units = [&](double cost) { return static_cast<int>(std::lround(unit_ * cost)); };
    gap_ = units(options.gap);
    // What is dearer than two gaps is never taken.
    const double dear = 2.0 * options.gap;
    const auto& directions = directions26();
    for (std::size_t i = 0; i < directions.size(); ++i) {
        for (std::size_t j = 0; j < directions.size(); ++j) {
            const double turn = 1.0 - static_cast<double>(directions[i].dot(directions[j]));
            // Rounding must not give equal directions a cost.
            const double cost = i == j ? 0.0 : std::clamp(turn, 0.0, 1.0);
            direction_[i][j] =
                static_cast<std::int16_t>(units(std::min(dear, options.direction_weight * cost)));
        }
    }
    const double limit = std::min(dear, options.radius_weight);
    const double slope = options.radius_weight * options.radius_gain * 0.5 * kRadiusLevelStep;
    radius_slope_ = units(slope);
    radius_limit_ = units(limit);
    radius_limit_levels_ = radius_slope_ > 0
                               ? std::min(256, (radius_limit_ + radius_slope_ - 1) / radius_slope_)
                               : 256;
    if (radius_slope_ == 0) radius_limit_ = 0;
}

float alignment_cost(std::span<const DirectionStep> s, std::span<const DirectionStep> p,
                     const AlignmentCosts& costs) {
    assert(s.size() <= kMaxAlignedSteps && p.size() <= kMaxAlignedSteps);
    if (s.empty() && p.empty()) return 0.0F;
    const int gap = costs.gap();
    std::array<int, kMaxAlignedSteps + 1> row;
    for (std::size_t j = 0; j <= p.size(); ++j) row[j] = gap * static_cast<int>(j);
    for (std::size_t i = 0; i < s.size(); ++i) {
        int diagonal = row[0];
        int left = gap * static_cast<int>(i + 1);
        row[0] = left;
        for (std::size_t j = 0; j < p.size(); ++j) {
            const int exchanged = diagonal + costs.step(s[i], p[j]);
            diagonal = row[j + 1];
            left = std::min(exchanged, std::min(diagonal, left) + gap);
            row[j + 1] = left;
        }
    }
    const auto longer = static_cast<double>(std::max(s.size(), p.size()));
    return static_cast<float>(row[p.size()] / (costs.unit() * longer));
}

}  // namespace ossuary::chain_code
