#include "engine/mesh/canonical_pose.h"

#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace ossuary::mesh {
namespace {

// Three bars of different length that meet in a corner: no symmetry, well separated axes.
TriangleMesh lopsided_mesh() {
    return test::merged(
        test::merged(test::box_mesh({0, 0, 0}, {9, 1, 1}), test::box_mesh({0, 0, 0}, {1, 4, 1})),
        test::box_mesh({0, 0, 0}, {1, 1, 2}));
}

void expect_orthonormal(const Mat3& axes) {
    EXPECT_TRUE((axes.transpose() * axes).isIdentity(1e-12)) << axes;
}

TEST(CanonicalPose, PutsTheWidestAxisFirstAndPointsToTheFarSide) {
    const Mat3 axes = canonical_pose(lopsided_mesh());
    expect_orthonormal(axes);
    EXPECT_GT(axes.col(0).x(), 0.9);
    EXPECT_GT(axes.col(1).y(), 0.9);
    EXPECT_GT(axes.col(2).z(), 0.9);
}

TEST(CanonicalPose, TurnsWithTheModel) {
    const TriangleMesh mesh = lopsided_mesh();
    const Mat3 axes = canonical_pose(mesh);
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Mat3 rotation = test::random_rotation(seed);
        const Mat3 turned = canonical_pose(test::transformed(mesh, rotation, {7, -3, 2}));
        EXPECT_TRUE(turned.isApprox(rotation * axes, 1e-9)) << turned;
    }
}

TEST(CanonicalPose, MirrorsWithTheModel) {
    const TriangleMesh mesh = lopsided_mesh();
    const Mat3 mirror = Vec3(1, -1, 1).asDiagonal();
    const Mat3 mirrored = canonical_pose(test::transformed(mesh, mirror, {0, 0, 0}));
    EXPECT_TRUE(mirrored.isApprox(mirror * canonical_pose(mesh), 1e-9)) << mirrored;
}

TEST(CanonicalPose, DoesNotDependOnScaleOrNumbering) {
    const TriangleMesh mesh = lopsided_mesh();
    const Mat3 axes = canonical_pose(mesh);
    EXPECT_TRUE(canonical_pose(test::renumbered(mesh, 5)).isApprox(axes, 1e-9));
    for (const double scale : {1e-30, 1e-6, 1e6, 1e30}) {
        const Mat3 scaled =
            canonical_pose(test::transformed(mesh, scale * Mat3::Identity(), {0, 0, 0}));
        EXPECT_TRUE(scaled.isApprox(axes, 1e-9)) << scale << "\n" << scaled;
    }
}

TEST(CanonicalPose, IsOrthonormalForWhateverHasNoAxesOfItsOwn) {
    expect_orthonormal(canonical_pose(test::box_mesh({0, 0, 0}, {1, 1, 1})));
    expect_orthonormal(canonical_pose(test::icosphere_mesh({0, 0, 0}, 1.0, 2)));
    TriangleMesh line = test::box_mesh({0, 0, 0}, {1, 0, 0});
    expect_orthonormal(canonical_pose(line));
    EXPECT_TRUE(canonical_pose(TriangleMesh{}).isIdentity());
}

}  // namespace
}  // namespace ossuary::mesh
