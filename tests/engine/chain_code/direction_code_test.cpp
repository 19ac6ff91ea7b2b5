#include "engine/chain_code/direction_code.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace ossuary::chain_code {
namespace {

struct Curve {
    std::vector<Vec3f> points;
    std::vector<float> radii;
};

Curve random_curve(std::mt19937& random, int count) {
    std::normal_distribution<float> normal;
    std::uniform_real_distribution<float> radius(0.02F, 0.3F);
    Curve curve;
    Vec3f direction(1, 0, 0), at(0, 0, 0);
    for (int i = 0; i < count; ++i) {
        curve.points.push_back(at);
        curve.radii.push_back(radius(random));
        direction += 0.4F * Vec3f(normal(random), normal(random), normal(random));
        at += 0.05F * direction.normalized();
    }
    return curve;
}

Eigen::Matrix3f random_rotation(std::mt19937& random) {
    std::normal_distribution<float> normal;
    return Eigen::Quaternionf(normal(random), normal(random), normal(random), normal(random))
        .normalized()
        .toRotationMatrix();
}

/// How many steps the two codes disagree in; rounding may move a step over the border between two
/// directions, but not many.
int differences(const std::vector<DirectionStep>& a, const std::vector<DirectionStep>& b) {
    EXPECT_EQ(a.size(), b.size());
    int count = 0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) count += a[i] == b[i] ? 0 : 1;
    return count;
}

TEST(Directions26, AreUnitVectorsEachWithItsOpposite) {
    for (const Vec3f& d : directions26()) {
        EXPECT_NEAR(d.norm(), 1.0F, 1e-6F);
        EXPECT_NEAR(directions26()[quantize_direction(-d)].dot(d), -1.0F, 1e-6F);
    }
}

TEST(Directions26, AreEachTheNearestToThemselves) {
    for (std::size_t i = 0; i < directions26().size(); ++i) {
        EXPECT_EQ(quantize_direction(2.5F * directions26()[i]), i);
    }
}

TEST(QuantizeRadius, GrowsByOneLevelForEachThreePercent) {
    EXPECT_EQ(quantize_radius(0.0), 0);
    EXPECT_EQ(quantize_radius(1e9), 255);
    const int base = quantize_radius(0.1);
    EXPECT_EQ(quantize_radius(0.1 * std::exp(10 * kRadiusLevelStep)), base + 10);
    EXPECT_EQ(quantize_radius(0.1 * std::exp(-10 * kRadiusLevelStep)), base - 10);
}

TEST(DirectionCode, OfAStraightBranchIsAllAlongTheChord) {
    std::vector<Vec3f> points;
    std::vector<float> radii;
    for (int i = 0; i < 6; ++i) {
        points.emplace_back(Vec3f(1, 2, -3) * static_cast<float>(i));
        radii.push_back(0.1F);
    }
    const std::vector<DirectionStep> code = direction_code(points, radii);
    ASSERT_EQ(code.size(), 5U);
    for (const DirectionStep& step : code) {
        EXPECT_EQ(step.direction, quantize_direction(Vec3f::UnitX()));
        EXPECT_EQ(step.radius_level, quantize_radius(0.1));
    }
}

TEST(DirectionCode, DoesNotChangeUnderRotationTranslationAndMirroring) {
    std::mt19937 random(21);
    int steps = 0, changed = 0;
    for (int round = 0; round < 100; ++round) {
        const Curve curve = random_curve(random, 20);
        const std::vector<DirectionStep> code = direction_code(curve.points, curve.radii);
        Eigen::Matrix3f motion = random_rotation(random);
        if (round % 2 == 1) motion.col(0) *= -1.0F;
        Curve moved = curve;
        for (Vec3f& p : moved.points) p = motion * p + Vec3f(3, -1, 2);
        changed += differences(code, direction_code(moved.points, moved.radii));
        steps += static_cast<int>(code.size());
    }
    EXPECT_LE(changed, steps / 200);
}

TEST(DirectionCode, TellsABendFromAStraightBranch) {
    std::vector<Vec3f> bend;
    for (int i = 0; i <= 5; ++i) bend.emplace_back(static_cast<float>(i), 0.0F, 0.0F);
    for (int i = 1; i <= 5; ++i) bend.emplace_back(5.0F, static_cast<float>(i), 0.0F);
    const std::vector<float> radii(bend.size(), 0.1F);
    const std::vector<DirectionStep> code = direction_code(bend, radii);
    // In the frame of the chord both arms stand at 45 degrees to it, one up and one down.
    const Vec3f first = directions26()[code.front().direction];
    const Vec3f last = directions26()[code.back().direction];
    EXPECT_NEAR(first.dot(last), 0.0F, 1e-6F);
    EXPECT_NEAR(first.x(), last.x(), 1e-6F);
    EXPECT_GT(first.y(), 0.0F);
    EXPECT_LT(last.y(), 0.0F);
}

TEST(BranchFrame, IsOrthonormalForDegenerateBranches) {
    const std::vector<std::vector<Vec3f>> curves = {
        {Vec3f(1, 1, 1), Vec3f(1, 1, 1)},
        {Vec3f(0, 0, 0), Vec3f(1, 0, 0), Vec3f(0, 0, 0)},
        {Vec3f(0, 0, 0), Vec3f(1, 0, 0), Vec3f(2, 0, 0)},
        {Vec3f(0, 0, 0), Vec3f(1, 1, 0), Vec3f(2, 0, 0), Vec3f(3, -1, 0), Vec3f(4, 0, 0)},
    };
    for (const auto& points : curves) {
        const Mat3 frame = branch_frame(points);
        EXPECT_NEAR((frame.transpose() * frame - Mat3::Identity()).norm(), 0.0, 1e-9);
    }
}

TEST(BranchFrame, LooksTheSameWayAlongAnS) {
    // An S deviates from its chord by nothing in the mean; its first half decides.
    std::vector<Vec3f> s;
    for (int i = 0; i <= 16; ++i) {
        const float t = static_cast<float>(i) / 16.0F;
        s.emplace_back(t, 0.2F * std::sin(6.2831853F * t), 0.0F);
    }
    EXPECT_GT(branch_frame(s).col(1).y(), 0.99);
}

}  // namespace
}  // namespace ossuary::chain_code
