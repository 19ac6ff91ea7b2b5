#include "engine/ranking/among_others.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace ossuary::ranking {
namespace {

/// Distances of points on a line.
DistanceMatrix on_a_line(const std::vector<float>& places) {
    DistanceMatrix matrix;
    matrix.size = places.size();
    for (const float a : places) {
        for (const float b : places) matrix.values.push_back(std::abs(a - b));
    }
    return matrix;
}

TEST(AmongOthers, LeavesOutWhatIsAlikeInTheOtherWay) {
    // Bodies a and b in poses 1 and 2: each body's poses are next to each other.
    const DistanceMatrix matrix = on_a_line({0.0F, 1.0F, 10.0F, 12.0F});
    const std::vector<std::string> body = {"a", "a", "b", "b"}, pose = {"1", "2", "2", "1"};
    const AmongOthers builds = among_others(matrix, body, pose);
    EXPECT_EQ(builds.queries, 4U);
    EXPECT_EQ(builds.nearest_neighbor, 1.0);
    EXPECT_EQ(builds.first_tier, 1.0);
    // Of the other body's two poses the nearer one is pose 2 for both of body a's, pose 2 of body a
    // for both of body b's.
    const AmongOthers poses = among_others(matrix, pose, body);
    EXPECT_EQ(poses.queries, 4U);
    EXPECT_EQ(poses.nearest_neighbor, 0.5);
    EXPECT_EQ(poses.first_tier, 0.5);
}

TEST(AmongOthers, CountsAllOfALabelInTheFirstTier) {
    const DistanceMatrix matrix = on_a_line({0.0F, 1.0F, 2.0F, 3.0F});
    const std::vector<std::string> none(4);
    // The first finds one of its two among the nearest two, as does the last.
    const AmongOthers found =
        among_others(matrix, std::vector<std::string>{"x", "x", "y", "x"}, none);
    EXPECT_EQ(found.queries, 3U);
    EXPECT_NEAR(found.nearest_neighbor, 2.0 / 3.0, 1e-12);
    EXPECT_NEAR(found.first_tier, 0.5, 1e-12);
}

TEST(AmongOthers, AsksNothingWhereThereIsNothingToFind) {
    const DistanceMatrix matrix = on_a_line({0.0F, 1.0F, 2.0F});
    const std::vector<std::string> same = {"x", "x", "x"}, none(3);
    EXPECT_EQ(among_others(matrix, same, same).queries, 0U);
    EXPECT_EQ(among_others(matrix, none, same).queries, 0U);
    EXPECT_EQ(among_others(matrix, none, same).nearest_neighbor, 0.0);
    EXPECT_EQ(among_others({}, {}, {}).queries, 0U);
}

TEST(AmongOthers, PutsWhatIsNotANumberLast) {
    DistanceMatrix matrix = on_a_line({0.0F, 1.0F, 2.0F});
    matrix.values[1] = std::nanf("");
    const std::vector<std::string> labels = {"x", "y", "x"}, none(3);
    EXPECT_EQ(among_others(matrix, labels, none).nearest_neighbor, 0.5);
}

}  // namespace
}  // namespace ossuary::ranking
