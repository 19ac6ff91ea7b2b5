#include "engine/chain_code/alignment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace ossuary::chain_code {
namespace {

using Code = std::vector<DirectionStep>;

Code random_code(std::mt19937& random, int length) {
    Code code;
    for (int i = 0; i < length; ++i) {
        code.push_back(
            {static_cast<std::uint8_t>(std::uniform_int_distribution<>(0, 25)(random)),
             static_cast<std::uint8_t>(std::uniform_int_distribution<>(100, 140)(random))});
    }
    return code;
}

/// The cheapest alignment, in units, by trying all of them.
int try_all(const Code& s, const Code& p, std::size_t i, std::size_t j,
            const AlignmentCosts& costs) {
    if (i == s.size() && j == p.size()) return 0;
    int best = 1 << 20;
    if (i < s.size()) best = std::min(best, costs.gap() + try_all(s, p, i + 1, j, costs));
    if (j < p.size()) best = std::min(best, costs.gap() + try_all(s, p, i, j + 1, costs));
    if (i < s.size() && j < p.size()) {
        best = std::min(best, costs.step(s[i], p[j]) + try_all(s, p, i + 1, j + 1, costs));
    }
    return best;
}

TEST(AlignmentCosts, AreThoseOfTheFormula) {
    const AlignmentCosts costs(AlignmentOptions{0.15, 0.7, 3.0, 0.6});
    const double half_unit = 0.5001 / costs.unit();
    EXPECT_NEAR(costs.gap() / costs.unit(), 0.6, half_unit);
    for (std::uint8_t i = 0; i < kDirectionCount; ++i) {
        for (std::uint8_t j = 0; j < kDirectionCount; ++j) {
            const double cosine = static_cast<double>(directions26()[i].dot(directions26()[j]));
            EXPECT_NEAR(costs.step({i, 9}, {j, 9}) / costs.unit(),
                        0.15 * std::min(1.0, 1.0 - cosine), half_unit);
        }
    }
    for (const double ratio : {1.0, 1.1, 1.3, 1.6, 3.0, 50.0}) {
        const double r = 0.02;
        const DirectionStep s{0, quantize_radius(r)}, p{0, quantize_radius(ratio * r)};
        const double expected = 0.7 * std::min(1.0, 1.5 * std::log(ratio));
        // Each of the two levels is rounded by up to half a level.
        const double one_level = 0.7 * 1.5 * kRadiusLevelStep;
        EXPECT_NEAR(costs.step(s, p) / costs.unit(), expected, one_level + 0.02 * expected);
    }
}

TEST(Alignment, FindsTheCheapestOfAllAlignments) {
    std::mt19937 random(31);
    const AlignmentCosts costs;
    for (int round = 0; round < 300; ++round) {
        const Code s = random_code(random, round % 7);
        const Code p = random_code(random, (round / 7) % 7);
        const double longer =
            static_cast<double>(std::max<std::size_t>(1, std::max(s.size(), p.size())));
        EXPECT_NEAR(alignment_cost(s, p, costs),
                    try_all(s, p, 0, 0, costs) / (costs.unit() * longer), 1e-6);
    }
}

TEST(Alignment, CostsNothingForEqualCodesAndIsSymmetricBitByBit) {
    std::mt19937 random(32);
    const AlignmentCosts costs;
    for (int round = 0; round < 200; ++round) {
        const Code s = random_code(random, 1 + round % 40);
        const Code p = random_code(random, 1 + (round * 7) % 40);
        EXPECT_EQ(alignment_cost(s, s, costs), 0.0F);
        EXPECT_EQ(alignment_cost(s, p, costs), alignment_cost(p, s, costs));
    }
}

TEST(Alignment, ChargesGapsForWhatOneCodeHasMore) {
    const AlignmentCosts costs;
    const Code four(4, DirectionStep{22, 120});
    const Code ten(10, DirectionStep{22, 120});
    EXPECT_NEAR(alignment_cost(four, ten, costs), 0.6 * 6 / 10, 2e-3);
    EXPECT_NEAR(alignment_cost(Code{}, ten, costs), 0.6, 2e-3);
    EXPECT_EQ(alignment_cost(Code{}, Code{}, costs), 0.0F);
}

TEST(Alignment, LetsThePoseWeightDecideHowMuchDirectionsCount) {
    const Code straight(8, DirectionStep{quantize_direction(Vec3f::UnitX()), 120});
    Code bent = straight;
    for (std::size_t i = 4; i < bent.size(); ++i) {
        bent[i].direction = quantize_direction(Vec3f::UnitY());
    }
    const auto cost = [&](double weight) {
        return alignment_cost(straight, bent, AlignmentCosts({weight, 0.7, 3.0, 0.6}));
    };
    EXPECT_EQ(cost(0.0), 0.0F);
    EXPECT_GT(cost(0.15), 0.0F);
    EXPECT_GT(cost(1.0), cost(0.15));
}

TEST(Alignment, HoldsTheLongestCodesWithoutOverflow) {
    for (const double gap : {0.05, 0.6, 4.0}) {
        const AlignmentCosts costs({3.0, 5.0, 3.0, gap});
        const Code thin(kMaxAlignedSteps, DirectionStep{0, 0});
        const Code thick(kMaxAlignedSteps, DirectionStep{25, 255});
        EXPECT_NEAR(alignment_cost(thin, thick, costs), 2.0 * gap, 0.05 * gap);
    }
}

}  // namespace
}  // namespace ossuary::chain_code
