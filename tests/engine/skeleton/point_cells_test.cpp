#include "engine/skeleton/point_cells.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "tests/support/random.h"

namespace ossuary::skeleton {
namespace {

std::vector<double> none_yet(std::size_t count) {
    return std::vector<double>(count, std::numeric_limits<double>::infinity());
}

void expect_same_as_looking_at_all(const std::vector<Vec3>& points, const Vec3& place) {
    std::vector<double> expected = none_yet(10), found = none_yet(10);
    for (const Vec3& point : points) insert_nearer((point - place).squaredNorm(), expected);
    PointCells(points).find_nearest(place, found);
    EXPECT_EQ(found, expected);
}

TEST(PointCells, FindTheSameAsLookingAtAll) {
    std::mt19937_64 random(1);
    const auto coordinate = [&](double scale) { return scale * (test::next_unit(random) - 0.5); };
    for (const Vec3& scale : {Vec3(1, 1, 1), Vec3(100, 1, 0.01), Vec3(5, 0, 0)}) {
        std::vector<Vec3> points;
        for (int i = 0; i < 3000; ++i) {
            points.emplace_back(coordinate(scale.x()), coordinate(scale.y()),
                                coordinate(scale.z()));
        }
        for (int i = 0; i < 200; ++i) {
            expect_same_as_looking_at_all(points,
                                          {coordinate(3 * scale.x()), coordinate(3 * scale.y()),
                                           coordinate(3 * scale.z() + 0.1)});
        }
    }
}

TEST(PointCells, TakeFewPointsAndEqualOnes) {
    expect_same_as_looking_at_all({Vec3(1, 2, 3)}, {0, 0, 0});
    expect_same_as_looking_at_all(std::vector<Vec3>(50, Vec3(1, 2, 3)), {1, 2, 3});
}

}  // namespace
}  // namespace ossuary::skeleton
