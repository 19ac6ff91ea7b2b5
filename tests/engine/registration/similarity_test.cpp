#include "engine/registration/similarity.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/random.h"
#include "tests/support/shapes.h"

namespace ossuary::registration {
namespace {

std::vector<Vec3> random_points(std::uint64_t seed, std::size_t count) {
    std::mt19937_64 random(seed);
    std::vector<Vec3> points(count);
    for (Vec3& point : points) {
        for (int axis = 0; axis < 3; ++axis) point[axis] = test::next_unit(random);
    }
    return points;
}

Similarity random_similarity(std::uint64_t seed, bool scale, bool mirror) {
    Similarity motion;
    motion.rotation = test::random_rotation(seed);
    if (mirror) motion.rotation.col(0) *= -1.0;
    if (scale) motion.scale = 0.1 + static_cast<double>(seed);
    motion.translation = Vec3(1.0, -2.0, 3.0) * static_cast<double>(seed);
    return motion;
}

std::vector<Vec3> placed(const Similarity& motion, std::vector<Vec3> points) {
    for (Vec3& point : points) point = motion.point(point);
    return points;
}

TEST(Similarity, ItsInverseUndoesIt) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const Similarity motion = random_similarity(seed, true, seed % 2 == 0);
        const Similarity nothing = compose(motion.inverse(), motion);
        EXPECT_LT((nothing.matrix() - Eigen::Matrix4d::Identity()).norm(), 1e-12);
        EXPECT_EQ(motion.inverse().mirrors(), motion.mirrors());
    }
}

TEST(Similarity, ComposedIsOneAfterTheOther) {
    const Similarity inner = random_similarity(1, true, true);
    const Similarity outer = random_similarity(2, true, false);
    const Vec3 x(0.3, 0.2, -0.7);
    EXPECT_LT((compose(outer, inner).point(x) - outer.point(inner.point(x))).norm(), 1e-12);
    const Eigen::Vector4d moved = compose(outer, inner).matrix() * x.homogeneous();
    EXPECT_LT((moved.head<3>() - outer.point(inner.point(x))).norm(), 1e-12);
}

TEST(FitSimilarity, FindsTheMotionThatPointsWereMovedBy) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const bool scale = seed % 2 == 0;
        const bool mirror = seed % 3 == 0;
        const Similarity motion = random_similarity(seed, scale, mirror);
        const std::vector<Vec3> points = random_points(seed, 4 + seed);
        const Similarity fit =
            fit_similarity(points, placed(motion, points), {.scale = scale, .mirror = mirror});
        EXPECT_LT((fit.matrix() - motion.matrix()).norm(), 1e-9 * (1.0 + motion.scale)) << seed;
    }
}

TEST(FitSimilarity, MirrorsOnlyWhenAsked) {
    const std::vector<Vec3> points = random_points(3, 30);
    const std::vector<Vec3> mirrored = placed(random_similarity(3, false, true), points);
    EXPECT_FALSE(fit_similarity(points, mirrored).mirrors());
    EXPECT_TRUE(fit_similarity(points, points, {.mirror = true}).mirrors());
}

TEST(FitSimilarity, PointsInOnePlaceAreMovedThere) {
    const std::vector<Vec3> one(3, Vec3(1, 2, 3));
    const std::vector<Vec3> other(3, Vec3(4, 5, 6));
    const Similarity fit = fit_similarity(one, other, {.scale = true});
    EXPECT_TRUE(fit.matrix().allFinite());
    EXPECT_LT((fit.point(one[0]) - other[0]).norm(), 1e-12);
}

}  // namespace
}  // namespace ossuary::registration
