#include "engine/core/geometry.h"

#include <gtest/gtest.h>

namespace ossuary {
namespace {

TEST(WorldFromGrid, GoesThereAndBack) {
    WorldFromGrid map;
    map.origin = Vec3(3, -1, 8);
    map.voxel_size = 0.25;
    map.rotation = Eigen::AngleAxisd(0.8, Vec3(1, 1, 0).normalized()).toRotationMatrix();
    const Vec3 grid(10.5, 3, 7.25);
    EXPECT_TRUE(map.grid(map.point(grid)).isApprox(grid, 1e-12));
    EXPECT_NEAR((map.point(grid) - map.point(Vec3::Zero())).norm(), map.length(grid.norm()), 1e-12);
    EXPECT_EQ(map.point(Vec3::Zero()), map.origin);
}

}  // namespace
}  // namespace ossuary
