#include "engine/descriptor/pose_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/descriptor/solid_surface.h"
#include "tests/support/shapes.h"

namespace ossuary::descriptor {
namespace {

/// A body of a trunk, a head, and two limbs at `left` and `right` (radians above the horizontal),
/// all of thickness `radius`; as a file laid along the axes of `turn` would hold it.
std::vector<std::uint8_t> figure(double left, double right, double radius = 2.0,
                                 const Mat3& turn = Mat3::Identity(), double limb_length = 18.0) {
    const Vec3 top(0.0, 0.0, 24.0);
    std::vector<test::Capsule> limbs = {{Vec3::Zero(), top, radius},
                                        {top, top + Vec3(0.0, 3.0, 6.0), 1.2 * radius}};
    for (const auto& [angle, side] : {std::pair(left, -1.0), std::pair(right, 1.0)}) {
        const Vec3 direction(side * std::cos(angle), 0.0, std::sin(angle));
        limbs.push_back({top, top + limb_length * direction, radius});
    }
    const voxel::BitVolume volume = test::capsule_volume(limbs);
    const SolidSurface surface = solid_surface(volume);
    return pose_points(shell_graph(surface, 2), 24.0, turn);
}

Mat3 turned(double angle, const Vec3& axis) {
    return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

TEST(PosePoints, AreNearForOneAndFarForAnotherPose) {
    const auto down = figure(-1.0, -1.0);
    EXPECT_EQ(pose_points_distance(down, down), 0.0);
    const double thicker = pose_points_distance(down, figure(-1.0, -1.0, 2.6));
    double last = thicker;
    for (const double angle : {-0.2, 0.6, 1.2}) {
        const double bent = pose_points_distance(down, figure(angle, angle));
        EXPECT_GT(bent, last) << angle;
        last = bent;
    }
    EXPECT_GT(last, 1.7 * thicker);
}

TEST(PosePoints, AreNearForOnePoseOfBodiesOfOtherLengthsAndGirths) {
    const auto body = figure(-0.9, 0.7);
    for (const double length : {14.0, 23.0}) {
        for (const double radius : {1.6, 2.6}) {
            const auto same = figure(-0.9, 0.7, radius, Mat3::Identity(), length);
            const auto other = figure(-0.3, 0.2, radius, Mat3::Identity(), length);
            const auto ours = figure(-0.3, 0.2);
            EXPECT_LT(pose_points_distance(body, same), pose_points_distance(body, other))
                << length << ' ' << radius;
            EXPECT_LT(pose_points_distance(body, same), pose_points_distance(body, ours))
                << length << ' ' << radius;
        }
    }
}

TEST(PosePoints, AreSymmetricBitByBit) {
    const auto a = figure(-1.0, 0.3), b = figure(0.9, -0.4), c = figure(0.1, 0.1, 3.0);
    EXPECT_EQ(pose_points_distance(a, b), pose_points_distance(b, a));
    EXPECT_EQ(pose_points_distance(a, c), pose_points_distance(c, a));
    EXPECT_EQ(pose_points_distance(b, c), pose_points_distance(c, b));
}

TEST(PosePoints, FindACopyHoweverItLiesInItsFile) {
    const auto pose = figure(-0.9, 0.7), other = figure(0.4, 0.6);
    const double apart = pose_points_distance(pose, other);
    for (const double angle : {0.3, 1.2, 2.5, std::numbers::pi}) {
        const auto copy = figure(-0.9, 0.7, 2.0, turned(angle, Vec3(1.0, 0.4, -0.3)));
        EXPECT_LT(pose_points_distance(pose, copy), 0.15 * apart) << angle;
    }
    Mat3 mirror = Mat3::Identity();
    mirror(0, 0) = -1.0;
    EXPECT_LT(pose_points_distance(pose, figure(-0.9, 0.7, 2.0, mirror)), 0.15 * apart);
}

TEST(PosePoints, TellHowABodyFacesAndItsMirrorImage) {
    // The same difference in pose counts more where the file is turned or mirrored, too.
    const auto pose = figure(-0.9, 0.7), other = figure(-0.4, 0.6);
    const auto turned_other = figure(-0.4, 0.6, 2.0, turned(std::numbers::pi, Vec3::UnitZ()));
    Mat3 mirror = Mat3::Identity();
    mirror(0, 0) = -1.0;
    const double apart = pose_points_distance(pose, other);
    EXPECT_GT(pose_points_distance(pose, turned_other), 1.02 * apart);
    EXPECT_GT(pose_points_distance(pose, figure(-0.4, 0.6, 2.0, mirror)), 1.01 * apart);
}

TEST(PosePoints, CopeWithNothingAndWithAPoint) {
    const auto nothing = pose_points({}, 1.0, Mat3::Identity());
    ASSERT_EQ(nothing.size(), kPosePointsSize);
    voxel::BitVolume one(Vec3i(3, 3, 3));
    one.set(1, 1, 1);
    const auto point = pose_points(shell_graph(solid_surface(one), 4), 1.0, Mat3::Identity());
    EXPECT_EQ(pose_points_distance(nothing, point), 0.0);
    const double far = pose_points_distance(point, figure(0.0, 0.0));
    EXPECT_TRUE(std::isfinite(far));
    EXPECT_GT(far, 0.0);
}

}  // namespace
}  // namespace ossuary::descriptor
