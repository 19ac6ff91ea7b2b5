#include "engine/chain_code/code_batch.h"

#include <gtest/gtest.h>

#include <random>

namespace ossuary::chain_code {
namespace {

using Code = std::vector<DirectionStep>;

std::vector<Code> random_codes(std::mt19937& random, int count, int longest) {
    std::vector<Code> codes(static_cast<std::size_t>(count));
    for (Code& code : codes) {
        code.resize(static_cast<std::size_t>(std::uniform_int_distribution<>(0, longest)(random)));
        for (DirectionStep& step : code) {
            step.direction =
                static_cast<std::uint8_t>(std::uniform_int_distribution<>(0, 25)(random));
            step.radius_level =
                static_cast<std::uint8_t>(std::uniform_int_distribution<>(0, 255)(random));
        }
    }
    return codes;
}

void expect_same_as_one_by_one(const std::vector<Code>& left, const std::vector<Code>& right,
                               const AlignmentCosts& costs, BatchAligner& aligner) {
    const std::vector<std::span<const DirectionStep>> spans(right.begin(), right.end());
    const CodeBatch batch(spans);
    ASSERT_EQ(batch.size(), right.size());
    aligner.start(batch, costs);
    std::vector<float> results(right.size());
    for (const Code& code : left) {
        aligner.align(code, results);
        for (std::size_t i = 0; i < right.size(); ++i) {
            EXPECT_EQ(results[i], alignment_cost(code, right[i], costs));
        }
    }
}

TEST(CodeBatch, AlignsAsOneByOneBitByBit) {
    std::mt19937 random(37);
    BatchAligner aligner;
    for (int round = 0; round < 60; ++round) {
        const AlignmentCosts costs(
            {0.1 * (round % 11), 0.7, 1.0 + round % 4, 0.2 + 0.1 * (round % 7)});
        expect_same_as_one_by_one(random_codes(random, 5, 30), random_codes(random, round % 20, 30),
                                  costs, aligner);
    }
}

TEST(CodeBatch, AlignsTheLongestCodes) {
    std::mt19937 random(38);
    BatchAligner aligner;
    const int longest = static_cast<int>(kMaxAlignedSteps);
    for (const double gap : {0.1, 0.6, 3.0}) {
        std::vector<Code> left = random_codes(random, 4, longest);
        left.emplace_back(kMaxAlignedSteps, DirectionStep{0, 0});
        std::vector<Code> right = random_codes(random, 9, longest);
        right.emplace_back(kMaxAlignedSteps, DirectionStep{25, 255});
        expect_same_as_one_by_one(left, right, AlignmentCosts({1.0, 2.0, 3.0, gap}), aligner);
    }
}

}  // namespace
}  // namespace ossuary::chain_code
