#include "engine/descriptor/solid_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/shapes.h"

namespace ossuary::descriptor {
namespace {

TEST(SolidSurface, HasTheAreaOfABall) {
    for (const double radius : {10.0, 20.0, 40.0}) {
        const SolidSurface surface = solid_surface(test::ball(radius).volume);
        // Counting faces would give 6 / 4 = 1.5 times the area.
        EXPECT_NEAR(surface.total_area / (4.0 * std::numbers::pi * radius * radius), 1.0, 0.06)
            << radius;
    }
}

TEST(SolidSurface, HasTheAreaOfACubeFarFromItsEdges) {
    const SolidSurface surface = solid_surface(test::cube(64).volume);
    EXPECT_NEAR(surface.total_area / (6.0 * 64.0 * 64.0), 1.0, 0.05);
}

TEST(SolidSurface, HasNormalsThatPointOutOfABall) {
    const voxel::BitVolume volume = test::ball(20.0).volume;
    const SolidSurface surface = solid_surface(volume);
    Vec3f center = Vec3f::Zero();
    for (const Vec3f& point : surface.points) center += point;
    center /= static_cast<float>(surface.points.size());
    for (std::size_t i = 0; i < surface.points.size(); ++i) {
        EXPECT_NEAR(surface.normals[i].norm(), 1.0F, 1e-5F);
        EXPECT_GT(surface.normals[i].dot((surface.points[i] - center).normalized()), 0.93F);
        EXPECT_NEAR((surface.points[i] - center).norm(), 20.0F, 1.5F);
    }
}

TEST(SolidSurface, TurnsWithTheVolume) {
    const voxel::BitVolume volume = test::capsule_tree().volume;
    const SolidSurface surface = solid_surface(volume);
    for (const Vec3i& order : {Vec3i(1, 2, 0), Vec3i(2, 1, 0), Vec3i(0, 2, 1)}) {
        const SolidSurface turned = solid_surface(test::permuted(volume, order));
        EXPECT_EQ(turned.points.size(), surface.points.size());
        EXPECT_NEAR(turned.total_area, surface.total_area, 1e-3 * surface.total_area);
    }
    const SolidSurface mirrored = solid_surface(test::mirrored(volume, 0));
    EXPECT_NEAR(mirrored.total_area, surface.total_area, 1e-3 * surface.total_area);
}

TEST(SolidSurface, CopesWithASingleVoxelAndWithNone) {
    voxel::BitVolume one(Vec3i(3, 3, 3));
    one.set(1, 1, 1);
    const SolidSurface surface = solid_surface(one);
    ASSERT_EQ(surface.points.size(), 1U);
    EXPECT_NEAR(surface.normals[0].norm(), 1.0F, 1e-6F);
    EXPECT_GT(surface.total_area, 0.0);
    EXPECT_TRUE(solid_surface(voxel::BitVolume(Vec3i(4, 4, 4))).empty());
    // A volume filled to its border: outside counts as empty.
    voxel::BitVolume full(Vec3i(70, 2, 2));
    for (int x = 0; x < 70; ++x) {
        for (int y = 0; y < 2; ++y) full.set(x, y, 0), full.set(x, y, 1);
    }
    EXPECT_EQ(solid_surface(full).points.size(), 280U);
}

}  // namespace
}  // namespace ossuary::descriptor
