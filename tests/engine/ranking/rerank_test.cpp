#include "engine/ranking/rerank.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

#include "tests/support/random.h"

namespace ossuary::ranking {
namespace {

/// Points on a line or in the plane with their distances.
struct Points {
    std::vector<std::pair<double, double>> at;

    [[nodiscard]] double distance(std::size_t i, std::size_t j) const {
        return std::hypot(at[i].first - at[j].first, at[i].second - at[j].second);
    }
    [[nodiscard]] std::vector<double> from(double x, double y) const {
        std::vector<double> row;
        for (const auto& [px, py] : at) row.push_back(std::hypot(px - x, py - y));
        return row;
    }
    [[nodiscard]] CollectionDistances among() const {
        return [this](std::size_t i, std::span<const std::size_t> others) {
            std::vector<double> row;
            for (const std::size_t j : others) row.push_back(distance(i, j));
            return row;
        };
    }
};

Points random_points(std::size_t count, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    Points points;
    for (std::size_t i = 0; i < count; ++i) {
        points.at.emplace_back(test::next_unit(random), test::next_unit(random));
    }
    return points;
}

TEST(Rerank, KeepsEveryModelAndThoseBelowItsDepthInTheirOldOrder) {
    const Points points = random_points(120, 5);
    const std::vector<double> distances = points.from(0.3, 0.6);
    const std::vector<double> result = rerank(distances, points.among(), {.depth = 40});
    ASSERT_EQ(result.size(), distances.size());
    std::vector<std::size_t> order(distances.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return distances[a] < distances[b]; });
    for (std::size_t i = 0; i < order.size(); ++i) {
        EXPECT_TRUE(std::isfinite(result[order[i]]));
        if (i < 40) {
            EXPECT_LT(result[order[i]], 1.0);
        } else {
            EXPECT_GE(result[order[i]], 1.0);
        }
        if (i > 40) {
            EXPECT_GT(result[order[i]], result[order[i - 1]]);
        }
    }
}

TEST(Rerank, PrefersTheQuerysClusterToANearerStranger) {
    // A chain of twenty points, 0.1 apart, ends at the query; a tight group of twenty strangers
    // lies across a gap, its rim a little nearer to the query than the chain's third point.
    Points points;
    for (int i = 0; i < 20; ++i) points.at.emplace_back(0.1 * i + 0.1, 0.01 * (i % 3));
    for (int i = 0; i < 20; ++i) points.at.emplace_back(-0.25 - 0.004 * i, 0.01 * (i % 5));
    const std::vector<double> distances = points.from(0.0, 0.0);
    ASSERT_LT(distances[20], distances[2]);
    const std::vector<double> result =
        rerank(distances, points.among(), {.neighbors = 6, .expansion = 3});
    EXPECT_LT(result[2], result[20]);
}

TEST(Rerank, LeavesAQueryThatIsInTheCollectionFirst) {
    const Points points = random_points(60, 9);
    for (std::size_t i = 0; i < 60; i += 7) {
        const auto distances = points.from(points.at[i].first, points.at[i].second);
        const auto result = rerank(distances, points.among());
        EXPECT_EQ(std::min_element(result.begin(), result.end()) - result.begin(),
                  static_cast<std::ptrdiff_t>(i));
        EXPECT_EQ(result[i], 0.0);
    }
}

TEST(Rerank, GivesTheSameBitsForEveryNumberOfJobs) {
    const Points points = random_points(200, 11);
    const auto distances = points.from(0.5, 0.5);
    EXPECT_EQ(rerank(distances, points.among(), {}, 1), rerank(distances, points.among(), {}, 4));
}

TEST(Rerank, CopesWithFewModels) {
    for (const std::size_t count : {0U, 1U, 2U, 3U}) {
        const Points points = random_points(count, 3);
        const auto result = rerank(points.from(2.0, 2.0), points.among());
        ASSERT_EQ(result.size(), count);
        for (const double d : result) EXPECT_TRUE(std::isfinite(d));
    }
}

TEST(Rerank, CopesWithCopiesAndInfiniteDistances) {
    Points points;
    for (int i = 0; i < 30; ++i) points.at.emplace_back(0.0, 0.0);
    const auto same = rerank(points.from(0.0, 0.0), points.among());
    for (const double d : same) EXPECT_TRUE(std::isfinite(d));
    const std::vector<double> infinite(30, INFINITY);
    for (const double d : rerank(infinite, points.among())) EXPECT_TRUE(std::isfinite(d));
}

}  // namespace
}  // namespace ossuary::ranking
