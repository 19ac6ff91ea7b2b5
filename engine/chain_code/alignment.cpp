#include "engine/chain_code/alignment.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace ossuary {

AlignmentCosts::AlignmentCosts(const AlignmentOptions& options)
    : options_(options), gap_(static_cast<float>(options.gap)) {
    const auto& directions = directions26();
    for (std::size_t i = 0; i < directions.size(); ++i) {
        for (std::size_t j = 0; j < directions.size(); ++j) {
            const double turn = 1.0 - static_cast<double>(directions[i].dot(directions[j]));
            // Rounding must not give equal directions a cost.
            const double cost = i == j ? 0.0 : std::clamp(turn, 0.0, 1.0);
            direction_[i][j] = static_cast<float>(options.direction_weight * cost);
        }
    }
    for (std::size_t levels = 0; levels < radius_.size(); ++levels) {
        // |r - r'| / (r + r') depends on the ratio of the radii alone.
        const double relative = std::tanh(0.5 * kRadiusLevelStep * static_cast<double>(levels));
        radius_[levels] = static_cast<float>(options.radius_weight *
                                             std::min(1.0, options.radius_gain * relative));
    }
}

float alignment_cost(std::span<const DirectionStep> s, std::span<const DirectionStep> p,
                     const AlignmentCosts& costs) {
    assert(s.size() <= kMaxAlignedSteps && p.size() <= kMaxAlignedSteps);
    if (s.empty() && p.empty()) return 0.0F;
    const float gap = costs.gap();
    std::array<float, kMaxAlignedSteps + 1> row;
    for (std::size_t j = 0; j <= p.size(); ++j) row[j] = gap * static_cast<float>(j);
    for (std::size_t i = 0; i < s.size(); ++i) {
        float diagonal = row[0];
        float left = gap * static_cast<float>(i + 1);
        row[0] = left;
        for (std::size_t j = 0; j < p.size(); ++j) {
            const float exchanged = diagonal + costs.step(s[i], p[j]);
            diagonal = row[j + 1];
            left = std::min(exchanged, std::min(diagonal, left) + gap);
            row[j + 1] = left;
        }
    }
    return row[p.size()] / static_cast<float>(std::max(s.size(), p.size()));
}

}  // namespace ossuary
