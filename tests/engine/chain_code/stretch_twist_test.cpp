#include "engine/chain_code/stretch_twist.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace ossuary::chain_code {
namespace {

std::string random_digits(std::mt19937& random, int longest) {
    std::string code;
    for (int left = std::uniform_int_distribution<>(0, longest)(random); left > 0; --left) {
        code.push_back(static_cast<char>('0' + std::uniform_int_distribution<>(0, 4)(random)));
    }
    return code;
}

void expect_counts(const StretchTwist& result, std::size_t same, std::size_t stretches,
                   std::size_t twists) {
    EXPECT_EQ(result.same, same);
    EXPECT_EQ(result.stretches, stretches);
    EXPECT_EQ(result.twists, twists);
}

TEST(StretchTwist, FindsNothingToDoForEqualCodes) {
    expect_counts(stretch_twist("0422", "0422"), 4, 0, 0);
    EXPECT_EQ(stretch_twist("0422", "0422").distance(), 0.0);
    EXPECT_EQ(stretch_twist("", "").distance(), 0.0);
}

TEST(StretchTwist, TwistsWhereCodesOfOneLengthDiffer) {
    expect_counts(stretch_twist("0120", "0340"), 2, 0, 2);
    EXPECT_DOUBLE_EQ(stretch_twist("0120", "0340").distance(), 0.5);
}

TEST(StretchTwist, StretchesTheShorterByTheLongersDescriptor) {
    // 0=0; 1 against 0: insert 0; 1=1; 2=2.
    expect_counts(stretch_twist("012", "0012"), 3, 1, 0);
    EXPECT_DOUBLE_EQ(stretch_twist("012", "0012").distance(), 0.25);
}

TEST(StretchTwist, TwistsOnceTheLengthsAgree) {
    // 1 against 0: insert; lengths agree; 1 against 2: twist; 1 against 3: twist.
    expect_counts(stretch_twist("11", "023"), 0, 1, 2);
    EXPECT_DOUBLE_EQ(stretch_twist("11", "023").distance(), 1.0);
}

TEST(StretchTwist, FillsUpAtTheEnd) {
    expect_counts(stretch_twist("04", "0444"), 2, 2, 0);
    expect_counts(stretch_twist("", "321"), 0, 3, 0);
    EXPECT_DOUBLE_EQ(stretch_twist("", "321").distance(), 1.0);
}

TEST(StretchTwist, IsSymmetricBoundedAndCountsEveryDescriptorOfTheLonger) {
    std::mt19937 random(7);
    for (int round = 0; round < 2000; ++round) {
        const std::string s = random_digits(random, 12);
        const std::string p = random_digits(random, 12);
        const StretchTwist there = stretch_twist(s, p);
        const StretchTwist back = stretch_twist(p, s);
        EXPECT_EQ(there.distance(), back.distance());
        EXPECT_GE(there.distance(), 0.0);
        EXPECT_LE(there.distance(), 1.0);
        EXPECT_EQ(there.same + there.stretches + there.twists, std::max(s.size(), p.size()));
        EXPECT_EQ(there.stretches, std::max(s.size(), p.size()) - std::min(s.size(), p.size()));
        EXPECT_EQ(there.distance() == 0.0, s == p);
    }
}

}  // namespace
}  // namespace ossuary::chain_code
