#include "engine/descriptor/histogram.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>

namespace ossuary::descriptor {
namespace {

TEST(Histogram, SharesAValueBetweenTheTwoNearestBins) {
    // Four bins over [0, 4]: centres at 0.5, 1.5, 2.5, 3.5.
    const HistogramAxis axis{0.0, 4.0, 4};
    EXPECT_EQ(axis.share(1.5).lower, 1U);
    EXPECT_DOUBLE_EQ(axis.share(1.5).upper_share, 0.0);
    EXPECT_EQ(axis.share(1.75).lower, 1U);
    EXPECT_EQ(axis.share(1.75).upper, 2U);
    EXPECT_DOUBLE_EQ(axis.share(1.75).upper_share, 0.25);
}

TEST(Histogram, PutsWhatLiesOutsideIntoTheEndBins) {
    const HistogramAxis axis{0.0, 4.0, 4};
    for (const double low : {-5.0, 0.0, 0.5, -std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_EQ(axis.share(low).lower, 0U);
        EXPECT_EQ(axis.share(low).upper_share, 0.0);
    }
    for (const double high : {3.5, 4.0, 99.0, std::numeric_limits<double>::infinity()}) {
        EXPECT_EQ(axis.share(high).lower, 3U);
        EXPECT_EQ(axis.share(high).upper, 3U);
    }
}

TEST(Histogram, SumsToOneAndKeepsWeights) {
    SoftHistogram<2> histogram({{{0.0, 2.0, 2}, {0.0, 2.0, 2}}});
    histogram.add({0.5, 0.5}, 3.0);
    histogram.add({1.5, 0.5}, 1.0);
    const std::vector<float> values = histogram.normalized();
    EXPECT_EQ(values, (std::vector<float>{0.75F, 0.0F, 0.25F, 0.0F}));
}

TEST(Histogram, SharesAValueAmongTheCornersOfItsCell) {
    SoftHistogram<3> histogram({{{0.0, 2.0, 2}, {0.0, 3.0, 3}, {0.0, 2.0, 2}}});
    histogram.add({0.75, 1.5, 1.0}, 2.0);
    const std::vector<float> values = histogram.normalized();
    std::vector<float> expected(12, 0.0F);
    expected[(0 * 3 + 1) * 2 + 0] = expected[(0 * 3 + 1) * 2 + 1] = 0.375F;
    expected[(1 * 3 + 1) * 2 + 0] = expected[(1 * 3 + 1) * 2 + 1] = 0.125F;
    EXPECT_EQ(values, expected);
}

TEST(Histogram, IsAllZeroWhenEmpty) {
    const std::vector<float> values =
        SoftHistogram<2>({{{0.0, 1.0, 3}, {0.0, 1.0, 3}}}).normalized();
    EXPECT_EQ(values, std::vector<float>(9, 0.0F));
}

}  // namespace
}  // namespace ossuary::descriptor
