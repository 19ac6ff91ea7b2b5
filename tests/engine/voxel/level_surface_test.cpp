#include "engine/voxel/level_surface.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "engine/mesh/edge_table.h"
#include "engine/mesh/inspect.h"
#include "engine/mesh/measures.h"

namespace ossuary::test {
namespace {

/// How far the points of a grid are inside a ball, by distance.
voxel::ScalarGrid ball_grid(int side, double radius) {
    voxel::ScalarGrid grid(Vec3i::Constant(side));
    const Vec3 middle = Vec3::Constant((side - 1) / 2.0);
    for (int z = 0; z < side; ++z) {
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                grid.at(x, y, z) = static_cast<float>(radius - (Vec3(x, y, z) - middle).norm());
            }
        }
    }
    return grid;
}

voxel::ScalarGrid random_grid(const Vec3i& size, double density, unsigned seed) {
    std::mt19937 random(seed);
    std::bernoulli_distribution set(density);
    voxel::ScalarGrid grid(size);
    for (int z = 1; z + 1 < size.z(); ++z) {
        for (int y = 1; y + 1 < size.y(); ++y) {
            for (int x = 1; x + 1 < size.x(); ++x) grid.at(x, y, z) = set(random) ? 1.0F : 0.0F;
        }
    }
    return grid;
}

TEST(LevelSurface, OfABallIsASphereFacingOutwards) {
    const mesh::TriangleMesh sphere = voxel::level_surface(ball_grid(40, 15.0), 0.0F);
    const mesh::MeshReport report = mesh::inspect(sphere);
    EXPECT_TRUE(report.closed && report.manifold && report.oriented);
    EXPECT_EQ(report.genus, 0);
    const mesh::MeshMeasures measures = mesh::measure(sphere);
    const double pi = std::numbers::pi;
    EXPECT_NEAR(measures.signed_volume, 4.0 / 3 * pi * 15 * 15 * 15, 80);
    EXPECT_NEAR(measures.surface_area, 4 * pi * 15 * 15, 15);
    EXPECT_LT((measures.bounds.center() - Vec3::Constant(19.5)).norm(), 1e-6);
}

TEST(LevelSurface, FollowsSpacingAndDirection) {
    voxel::ScalarGrid grid = ball_grid(24, 9.0);
    grid.origin = Vec3(100, 0, -3);
    grid.axes << 0, 2, 0, 1, 0, 0, 0, 0, -3;  // x and y change places, z is turned over: no mirror
    const mesh::MeshMeasures turned = mesh::measure(voxel::level_surface(grid, 0.0F));
    const double plain =
        mesh::measure(voxel::level_surface(ball_grid(24, 9.0), 0.0F)).signed_volume;
    EXPECT_NEAR(turned.signed_volume, 6 * plain, 1e-2 * plain);
    EXPECT_LT((turned.bounds.center() - Vec3(123, 11.5, -37.5)).norm(), 1e-6);
    grid.axes.col(2) *= -1;  // now it mirrors
    EXPECT_NEAR(mesh::measure(voxel::level_surface(grid, 0.0F)).signed_volume, 6 * plain,
                1e-2 * plain);
}

TEST(LevelSurface, IsClosedAndOrientedWhateverIsSet) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const voxel::ScalarGrid grid = random_grid({9, 8, 7}, 0.05 + 0.045 * seed, seed);
        const mesh::TriangleMesh surface = voxel::level_surface(grid, 0.5F);
        const mesh::EdgeTable table = mesh::build_edge_table(surface);
        for (const mesh::EdgeTable::Edge& edge : table.edges) {
            int balance = 0;
            for (const std::uint32_t side : table.sides_of(edge)) {
                balance += mesh::goes_up(surface, side) ? 1 : -1;
            }
            ASSERT_EQ(balance, 0) << "seed " << seed;
        }
        ASSERT_GT(mesh::measure(surface).signed_volume, 0.0);
    }
}

TEST(LevelSurface, KeepsDiagonalNeighboursTogether) {
    voxel::ScalarGrid grid(Vec3i::Constant(6));
    grid.at(2, 2, 2) = grid.at(3, 3, 2) = 1.0F;
    EXPECT_EQ(mesh::inspect(voxel::level_surface(grid, 0.5F)).components, 1U);
    grid.at(3, 3, 2) = 0.0F;
    grid.at(4, 4, 2) = 1.0F;
    EXPECT_EQ(mesh::inspect(voxel::level_surface(grid, 0.5F)).components, 2U);
}

TEST(LevelSurface, OfNothingIsEmpty) {
    EXPECT_TRUE(voxel::level_surface(voxel::ScalarGrid(Vec3i::Constant(5)), 0.5F).empty());
    EXPECT_TRUE(voxel::level_surface(voxel::ScalarGrid(Vec3i(5, 5, 1)), 0.5F).empty());
}

}  // namespace
}  // namespace ossuary::test
