#include "engine/skeleton/tube_radii.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace ossuary::skeleton {
namespace {

/// The voxels of a box of y and z extent `y` by `z` about the axis through (·, 20, 20).
void fill_bar(voxel::BitVolume& solid, int x_begin, int x_end, int y, int z) {
    for (int k = 20 - z / 2; k < 20 - z / 2 + z; ++k) {
        for (int j = 20 - y / 2; j < 20 - y / 2 + y; ++j) {
            for (int i = x_begin; i < x_end; ++i) solid.set(i, j, k);
        }
    }
}

SkeletonGraph axis(double x_begin, double x_end, double radius) {
    SkeletonGraph graph;
    SkeletonGraph::Branch branch{0, 1, {}, {}};
    for (double x = x_begin; x <= x_end; x += 1.0) {
        branch.points.emplace_back(x, 20.0, 20.0);
        branch.radii.push_back(radius);
    }
    graph.nodes.push_back({branch.points.front(), radius, 0.0, 1});
    graph.nodes.push_back({branch.points.back(), radius, 0.0, 1});
    graph.branches.push_back(branch);
    return graph;
}

TEST(TubeRadii, AreThoseOfTheCylinderWithTheBarsCrossSection) {
    voxel::BitVolume solid(Vec3i(80, 40, 40));
    fill_bar(solid, 10, 70, 6, 10);
    const auto radii = tube_radii(axis(10.0, 70.0, 3.0), solid);
    ASSERT_EQ(radii.size(), 1U);
    ASSERT_EQ(radii[0].size(), 61U);
    const double expected = std::sqrt(60.0 / std::numbers::pi);
    for (std::size_t i = 5; i + 5 < radii[0].size(); ++i) {
        EXPECT_NEAR(radii[0][i], expected, 1e-6) << "at point " << i;
    }
}

TEST(TubeRadii, TellAFlatLimbFromARoundOneOfTheSameInscribedRadius) {
    voxel::BitVolume flat(Vec3i(80, 40, 40)), round(Vec3i(80, 40, 40));
    fill_bar(flat, 10, 70, 4, 24);
    fill_bar(round, 10, 70, 4, 4);
    const SkeletonGraph graph = axis(10.0, 70.0, 2.0);
    EXPECT_GT(tube_radii(graph, flat)[0][30], 2.0 * tube_radii(graph, round)[0][30]);
}

TEST(TubeRadii, LeaveTheThickBodyToItselfWhereAThinLimbLeavesIt) {
    voxel::BitVolume solid(Vec3i(80, 40, 40));
    fill_bar(solid, 0, 30, 20, 20);  // body
    fill_bar(solid, 30, 80, 4, 4);   // limb
    SkeletonGraph graph = axis(0.0, 20.0, 10.0);
    SkeletonGraph limb = axis(20.0, 80.0, 2.0);
    for (std::size_t i = 0; i < 10; ++i) {
        limb.branches[0].radii[i] = 10.0 - 0.8 * static_cast<double>(i);
    }
    limb.branches[0].a = 1;
    limb.branches[0].b = 2;
    graph.nodes.push_back(limb.nodes[1]);
    graph.branches.push_back(limb.branches[0]);
    const auto radii = tube_radii(graph, solid);
    const double expected = std::sqrt(16.0 / std::numbers::pi);
    for (std::size_t i = 15; i < 55; ++i) EXPECT_NEAR(radii[1][i], expected, 0.1) << i;
}

TEST(TubeRadii, ChangeLessUnderARoughSurfaceThanInscribedOnes) {
    voxel::BitVolume smooth(Vec3i(80, 40, 40));
    fill_bar(smooth, 10, 70, 8, 8);
    voxel::BitVolume rough = smooth;
    // Every other voxel of one side missing: the inscribed radius falls from 4 to 3 voxels.
    for (int x = 10; x < 70; x += 2) {
        for (int z = 16; z < 24; ++z) rough.reset(x, 16, z);
    }
    const SkeletonGraph graph = axis(10.0, 70.0, 4.0);
    const double change = tube_radii(graph, smooth)[0][30] - tube_radii(graph, rough)[0][30];
    EXPECT_GT(change, 0.0);
    EXPECT_LT(change, 0.2);
}

TEST(TubeVolume, IsThatOfACylinder) {
    EXPECT_NEAR(tube_volume(axis(10.0, 70.0, 3.0)), 60.0 * 9.0 * std::numbers::pi, 1e-6);
    EXPECT_EQ(tube_volume({}), 0.0);
}

TEST(TubeRadii, OfASkeletonWithoutBranchesAreNone) {
    voxel::BitVolume solid(Vec3i(40, 40, 40));
    fill_bar(solid, 10, 20, 10, 10);
    SkeletonGraph point;
    point.nodes.push_back({Vec3(15, 20, 20), 5.0, 0.0, 0});
    EXPECT_TRUE(tube_radii(point, solid).empty());
}

}  // namespace
}  // namespace ossuary::skeleton
