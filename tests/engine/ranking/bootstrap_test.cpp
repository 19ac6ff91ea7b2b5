#include "engine/ranking/bootstrap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "tests/support/random.h"

namespace ossuary::ranking {
namespace {

TEST(Bootstrap, HasTheWidthOfTheNormalInterval) {
    std::mt19937_64 random(11);
    std::vector<double> values;
    for (int i = 0; i < 400; ++i) values.push_back(test::next_unit(random) < 0.3 ? 1.0 : 0.0);
    const BootstrapMean found = bootstrap_mean(values);
    EXPECT_NEAR(found.mean, 0.3, 0.06);
    EXPECT_LT(found.low, found.mean);
    EXPECT_GT(found.high, found.mean);
    const double expected = 2.0 * 1.96 * std::sqrt(found.mean * (1.0 - found.mean) / 400.0);
    EXPECT_NEAR(found.high - found.low, expected, 0.15 * expected);
    EXPECT_EQ(bootstrap_mean(values).low, found.low);
}

TEST(Bootstrap, HasNoWidthWhereAllValuesAgree) {
    const BootstrapMean found = bootstrap_mean(std::vector<double>(7, 0.25));
    EXPECT_EQ(found.mean, 0.25);
    EXPECT_EQ(found.low, 0.25);
    EXPECT_EQ(found.high, 0.25);
    EXPECT_EQ(bootstrap_mean({}).high, 0.0);
}

TEST(Bootstrap, ComparesQueryByQuery) {
    // The second is better by a tenth for every query, however unlike the queries are.
    RetrievalReport first, second;
    for (std::size_t i = 0; i < 30; ++i) {
        QueryMetrics query;
        query.model = i;
        query.metrics.first_tier = 0.03 * static_cast<double>(i);
        first.per_query.push_back(query);
        query.metrics.first_tier += 0.1;
        second.per_query.push_back(query);
    }
    const auto measure = &RetrievalMetrics::first_tier;
    const BootstrapMean gain = bootstrap_difference(first, second, measure);
    EXPECT_NEAR(gain.low, 0.1, 1e-12);
    EXPECT_NEAR(gain.high, 0.1, 1e-12);
    EXPECT_GT(bootstrap_measure(first, measure).high - bootstrap_measure(first, measure).low, 0.1);
    EXPECT_NEAR(bootstrap_difference(second, first, measure).mean, -0.1, 1e-12);
}

}  // namespace
}  // namespace ossuary::ranking
