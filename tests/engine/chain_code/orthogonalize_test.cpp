#include "engine/chain_code/orthogonalize.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "engine/chain_code/five_element_code.h"

namespace ossuary::chain_code {
namespace {

std::vector<Vec3> smooth_curve(std::mt19937& random, int count) {
    std::normal_distribution<double> normal;
    Vec3 direction = Vec3(normal(random), normal(random), normal(random)).normalized();
    std::vector<Vec3> points = {Vec3(normal(random), normal(random), normal(random)) * 10.0};
    for (int i = 1; i < count; ++i) {
        direction += 0.25 * Vec3(normal(random), normal(random), normal(random));
        direction.normalize();
        points.push_back(points.back() + 0.9 * direction);
    }
    return points;
}

void expect_lattice_path(const std::vector<Vec3i>& path) {
    ASSERT_FALSE(path.empty());
    for (std::size_t i = 1; i < path.size(); ++i) {
        EXPECT_EQ((path[i] - path[i - 1]).cwiseAbs().sum(), 1);
        if (i >= 2) {
            EXPECT_NE(path[i], path[i - 2]);
        }
    }
}

TEST(Orthogonalize, GivesOneVoxelForAPoint) {
    const std::vector<Vec3> point = {Vec3(2.5, -0.5, 7.9)};
    EXPECT_EQ(orthogonalize(point), std::vector<Vec3i>{Vec3i(2, -1, 7)});
}

TEST(Orthogonalize, FollowsAnAxis) {
    const std::vector<Vec3> line = {Vec3(0.5, 0.5, 0.5), Vec3(4.5, 0.5, 0.5)};
    const std::vector<Vec3i> path = orthogonalize(line);
    ASSERT_EQ(path.size(), 5U);
    EXPECT_EQ(five_element_code(path), "000");
}

TEST(Orthogonalize, TurnsADiagonalIntoAStaircase) {
    const std::vector<Vec3> line = {Vec3(0.5, 0.5, 0.5), Vec3(4.5, 4.5, 0.5)};
    const std::vector<Vec3i> path = orthogonalize(line);
    EXPECT_EQ(path.size(), 9U);
    EXPECT_EQ(five_element_code(path), "4222222");
}

TEST(Orthogonalize, TakesTheStepWithTheHighestDescriptor) {
    // Along x, then y, then to a diagonal neighbour that +z and -x lead to: with b = x and c = y
    // the step -x has descriptor 4, +z has 1.
    const std::vector<Vec3> points = {Vec3(0.5, 0.5, 0.5), Vec3(1.5, 0.5, 0.5), Vec3(1.5, 1.5, 0.5),
                                      Vec3(0.5, 1.5, 1.5)};
    const std::vector<Vec3i> path = orthogonalize(points);
    ASSERT_EQ(path.size(), 5U);
    EXPECT_EQ(path[3], Vec3i(0, 1, 0));
    EXPECT_EQ(path[4], Vec3i(0, 1, 1));
}

TEST(Orthogonalize, MakesUnitStepsThroughTheCurvesVoxels) {
    std::mt19937 random(3);
    for (int round = 0; round < 200; ++round) {
        const std::vector<Vec3> curve = smooth_curve(random, 40);
        const std::vector<Vec3i> path = orthogonalize(curve);
        expect_lattice_path(path);
        for (const Vec3& p : curve) {
            const double nearest = std::accumulate(
                path.begin(), path.end(), 1e9, [&](double least, const Vec3i& voxel) {
                    const Vec3 centre = voxel.cast<double>().array() + 0.5;
                    return std::min(least, (centre - p).cwiseAbs().maxCoeff());
                });
            EXPECT_LE(nearest, 1.5);
        }
    }
}

TEST(Orthogonalize, LeavesOutStepsThatAreTakenBack) {
    const std::vector<Vec3> spike = {Vec3(0.5, 0.5, 0.5), Vec3(3.5, 0.5, 0.5), Vec3(1.5, 0.5, 0.5),
                                     Vec3(1.5, 3.5, 0.5)};
    const std::vector<Vec3i> path = orthogonalize(spike);
    expect_lattice_path(path);
    EXPECT_EQ(path.back(), Vec3i(1, 3, 0));
    EXPECT_EQ(path.size(), 5U);
}

TEST(Orthogonalize, GivesTheSameCodeOnAQuarterTurnedLattice) {
    std::mt19937 random(5);
    const Eigen::Matrix3d turns[] = {
        (Eigen::Matrix3d() << 0, -1, 0, 1, 0, 0, 0, 0, 1).finished(),
        (Eigen::Matrix3d() << 0, 0, 1, 1, 0, 0, 0, 1, 0).finished(),
        (Eigen::Matrix3d() << -1, 0, 0, 0, -1, 0, 0, 0, 1).finished(),
    };
    int compared = 0;
    for (int round = 0; round < 100; ++round) {
        const std::vector<Vec3> curve = smooth_curve(random, 30);
        const std::vector<Vec3i> path = orthogonalize(curve);
        const Vec3i reach = (path.back() - path.front()).cwiseAbs();
        // Where two axes reach equally far the lower one wins, which a turn may change.
        if (reach.x() == reach.y() || reach.y() == reach.z() || reach.x() == reach.z()) continue;
        ++compared;
        for (const Eigen::Matrix3d& turn : turns) {
            std::vector<Vec3> turned;
            for (const Vec3& p : curve) turned.emplace_back(turn * p);
            EXPECT_EQ(five_element_code(orthogonalize(turned)), five_element_code(path));
        }
    }
    EXPECT_GT(compared, 50);
}

}  // namespace
}  // namespace ossuary::chain_code
