#include "engine/skeleton/smooth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace ossuary::skeleton {
namespace {

SkeletonGraph::Branch curve(int count, const std::function<Vec3(double)>& at) {
    SkeletonGraph::Branch branch;
    branch.b = 1;
    for (int i = 0; i < count; ++i) {
        branch.points.push_back(at(static_cast<double>(i) / (count - 1)));
        branch.radii.push_back(2.0);
    }
    return branch;
}

SkeletonGraph::Branch line(int count) {
    return curve(count, [&](double t) { return Vec3(t * count, 2.0 * t * count, 0.0); });
}

SkeletonGraph::Branch half_circle(int count, double radius) {
    return curve(count, [&](double t) {
        return Vec3(radius * std::cos(std::numbers::pi * t),
                    radius * std::sin(std::numbers::pi * t), 0.0);
    });
}

TEST(Smoothing, HoldsTheEndsAndLeavesAStraightBranchStraight) {
    for (const double variance : {0.5, 4.0, 24.0, 400.0}) {
        const SkeletonGraph::Branch before = line(30);
        SkeletonGraph::Branch after = before;
        smooth_branch(after, variance);
        for (std::size_t i = 0; i < before.points.size(); ++i) {
            EXPECT_LT((after.points[i] - before.points[i]).norm(), 1e-9) << i;
            EXPECT_NEAR(after.radii[i], 2.0, 1e-12);
        }
    }
}

TEST(Smoothing, TakesTheJitterOutOfANoisyLine) {
    std::mt19937 random(3);
    const auto jitter = [&] { return static_cast<double>(random() % 1001) / 1000.0 - 0.5; };
    SkeletonGraph::Branch noisy = line(100);
    for (std::size_t i = 1; i + 1 < noisy.points.size(); ++i) {
        noisy.points[i] += Vec3(jitter(), jitter(), jitter());
    }
    const double chord = (noisy.points.back() - noisy.points.front()).norm();
    SkeletonGraph::Branch smooth = noisy;
    smooth_branch(smooth, 4.0);
    EXPECT_LT(smooth.length() - chord, 0.2 * (noisy.length() - chord));
    EXPECT_EQ(smooth.points.front(), noisy.points.front());
    EXPECT_EQ(smooth.points.back(), noisy.points.back());
}

TEST(Smoothing, LeavesTwoPointsAlone) {
    SkeletonGraph::Branch two = line(2);
    const SkeletonGraph::Branch before = two;
    smooth_branch(two, 10.0);
    EXPECT_EQ(two.points, before.points);
}

TEST(Smoothing, KeepsAClosedCurveClosedAndCentred) {
    SkeletonGraph::Branch circle = curve(101, [](double t) {
        return Vec3(20.0 * std::cos(2.0 * std::numbers::pi * t),
                    20.0 * std::sin(2.0 * std::numbers::pi * t), 0.0);
    });
    circle.b = 0;
    SkeletonGraph::Node node{circle.points.front(), 2.0, 0.0, 2};
    smooth_closed_branch(circle, node, 4.0);
    EXPECT_EQ(circle.points.front(), circle.points.back());
    EXPECT_EQ(circle.points.front(), node.position);
    for (const Vec3& point : circle.points) {
        // The amplitude of the first harmonic falls by exp(-t w^2 / 2), w = 2 pi / n.
        const double w = 2.0 * std::numbers::pi / 100.0;
        EXPECT_NEAR(point.norm(), 20.0 * std::exp(-4.0 * w * w / 2.0), 0.01);
    }
}

TEST(Bending, IsZeroForALineAndGrowsWithTheBend) {
    EXPECT_NEAR(bending(line(50)), 0.0, 1e-9);
    const SkeletonGraph::Branch gentle = curve(
        101, [](double t) { return Vec3(100.0 * t, 5.0 * std::sin(std::numbers::pi * t), 0.0); });
    const double half = bending(half_circle(101, 30.0));
    EXPECT_GT(bending(gentle), 0.01);
    EXPECT_GT(half, bending(gentle));
    // On a half circle theta_s + theta_e = 90 degrees (Thales), theta_s uniform in [0, 90].
    EXPECT_NEAR(half, 2.0 / std::numbers::pi, 0.02);
}

TEST(Bending, DoesNotDependOnScaleOrDirection) {
    SkeletonGraph::Branch branch = half_circle(80, 30.0);
    const double expected = bending(branch);
    EXPECT_NEAR(bending(half_circle(80, 3.0)), expected, 1e-9);
    std::reverse(branch.points.begin(), branch.points.end());
    EXPECT_NEAR(bending(branch), expected, 1e-9);
}

TEST(Bending, SetsTheScaleInBothReadingsOfTheThesis) {
    const SkeletonGraph::Branch branch = half_circle(100, 30.0);
    const double f = bending(branch);
    EXPECT_NEAR(smoothing_variance(branch, SmoothingScale::kBendingSum, 400.0), f * 100.0, 1e-9);
    EXPECT_NEAR(smoothing_variance(branch, SmoothingScale::kQuotient, 400.0), 100.0 / f, 1e-9);
    EXPECT_EQ(smoothing_variance(branch, SmoothingScale::kFixed, 400.0), 0.0);
    EXPECT_EQ(smoothing_variance(line(100), SmoothingScale::kQuotient, 400.0), 400.0);
    EXPECT_EQ(smoothing_variance(branch, SmoothingScale::kQuotient, 10.0), 10.0);
}

}  // namespace
}  // namespace ossuary::skeleton
