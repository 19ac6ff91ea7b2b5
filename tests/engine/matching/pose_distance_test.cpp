#include "engine/matching/pose_distance.h"

#include <gtest/gtest.h>

#include "tests/engine/matching/built_skeletons.h"

namespace ossuary::matching {
namespace {

using test::describe;

/// A trunk with two straight arms and two straight legs; each arm is raised by an angle.
skeleton::SkeletonGraph figure(double left, double right) {
    test::SkeletonBuilder body;
    const auto chest = body.node(Vec3(0, 0, 50), 9);
    const auto hips = body.node(Vec3(0, 0, 0), 10);
    body.branch(hips, chest);
    body.branch(chest, body.node(Vec3(0, 0, 85), 7));
    for (const double side : {-1.0, 1.0}) {
        body.branch(hips, body.node(Vec3(side * 25, 0, -90), 5));
        const double angle = side < 0.0 ? left : right;
        body.branch(chest,
                    body.node(Vec3(side * 60 * std::cos(angle), 0, 50 + 60 * std::sin(angle)), 4));
    }
    return body.graph();
}

double pose_distance_of(const skeleton::SkeletonGraph& a, const skeleton::SkeletonGraph& b) {
    return pose_distance(describe(a), describe(b));
}

TEST(PoseDistance, SeesHowLimbsAreHeldWhichBranchesInTheirOwnFramesDoNot) {
    const skeleton::SkeletonGraph down = figure(-1.2, -1.2);
    SkeletonMatchOptions options;
    options.pose = 1.0;
    SkeletonMatchWorkspace workspace;
    double last = 0.0;
    for (const double raised : {-0.6, 0.0, 0.6, 1.2}) {
        const skeleton::SkeletonGraph other = figure(-1.2, raised);
        EXPECT_NEAR(skeleton_distance(describe(down), describe(other), options, workspace), 0.0,
                    0.01);
        EXPECT_GT(pose_distance_of(down, other), last + 0.005);
        last = pose_distance_of(down, other);
    }
}

TEST(PoseDistance, TakesAMirroredPoseForTheSame) {
    EXPECT_NEAR(pose_distance_of(figure(-1.2, 0.9), figure(0.9, -1.2)), 0.0, 1e-3);
    EXPECT_GT(pose_distance_of(figure(-1.2, -1.2), figure(0.9, -1.2)), 0.02);
}

TEST(PoseDistance, IsNoMatterOfPlaceSizeTurningOrNumbering) {
    std::mt19937 random(41);
    const Mat3 turn = Eigen::AngleAxisd(2.0, Vec3(1, 1, -3).normalized()).toRotationMatrix();
    const Mat3 mirror = Vec3(1, 1, -1).asDiagonal();
    const skeleton::SkeletonGraph a = test::human(0.2);
    const skeleton::SkeletonGraph b = test::human(0.9);
    const double expected = pose_distance_of(a, b);
    EXPECT_GT(expected, 0.01);
    for (const Mat3& linear : {turn, mirror}) {
        const skeleton::SkeletonGraph moved =
            test::moved(test::renumbered(b, random), linear, Vec3(3, 2, 1), 2.5);
        EXPECT_NEAR(pose_distance(describe(a), describe(moved, 250.0)), expected, 2e-3);
    }
}

TEST(PoseDistance, IsSymmetricBitByBitBoundedAndZeroForEqualSkeletons) {
    std::mt19937 random(42);
    std::vector<SkeletonDescriptor> all = {
        describe(test::cup()),      describe(test::ring()),
        describe(test::point()),    describe(skeleton::SkeletonGraph{}),
        describe(test::human(0.4)), describe(test::four_leg(0.7))};
    for (int round = 0; round < 12; ++round) {
        all.push_back(describe(test::random_skeleton(random, 2 + round, round % 3)));
    }
    for (const auto& a : all) {
        EXPECT_EQ(pose_distance(a, a), 0.0);
        for (const auto& b : all) {
            EXPECT_EQ(pose_distance(a, b), pose_distance(b, a));
            EXPECT_GE(pose_distance(a, b), 0.0);
            EXPECT_LE(pose_distance(a, b), 1.0);
        }
    }
}

}  // namespace
}  // namespace ossuary::matching
