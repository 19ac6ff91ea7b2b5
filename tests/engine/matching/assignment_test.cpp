#include "engine/matching/assignment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace ossuary::matching {
namespace {

/// The least total over all ways to give each row a column of its own.
double least_cost(const std::vector<float>& costs, std::size_t rows, std::size_t columns) {
    std::vector<std::size_t> order(columns);
    std::iota(order.begin(), order.end(), 0U);
    double best = 1e9;
    do {
        double sum = 0.0;
        for (std::size_t r = 0; r < rows; ++r)
            sum += static_cast<double>(costs[r * columns + order[r]]);
        best = std::min(best, sum);
    } while (std::next_permutation(order.begin(), order.end()));
    return best;
}

TEST(Assignment, IsTheCheapestOfAllAssignments) {
    std::mt19937 random(41);
    Assignment assignment;
    for (int round = 0; round < 600; ++round) {
        const std::size_t rows = 1 + static_cast<std::size_t>(round) % 5;
        const std::size_t columns = rows + (static_cast<std::size_t>(round) / 5) % 3;
        std::vector<float> costs(rows * columns);
        // Small whole numbers make many ties, negative ones are allowed.
        std::uniform_real_distribution<float> fine(-3.0F, 3.0F);
        std::uniform_int_distribution<> coarse(-2, 2);
        for (float& cost : costs) {
            cost = round % 2 == 0 ? fine(random) : static_cast<float>(coarse(random));
        }
        const auto found = assignment.solve(costs, rows, columns);
        ASSERT_EQ(found.size(), rows);
        double sum = 0.0;
        std::vector<bool> taken(columns, false);
        for (std::size_t r = 0; r < rows; ++r) {
            ASSERT_LT(found[r], columns);
            EXPECT_FALSE(taken[found[r]]);
            taken[found[r]] = true;
            sum += static_cast<double>(costs[r * columns + found[r]]);
        }
        EXPECT_NEAR(sum, least_cost(costs, rows, columns), 1e-5);
    }
}

TEST(Assignment, OfNothingIsEmpty) {
    Assignment assignment;
    EXPECT_TRUE(assignment.solve({}, 0, 0).empty());
    EXPECT_TRUE(assignment.solve({}, 0, 3).empty());
}

}  // namespace
}  // namespace ossuary::matching
