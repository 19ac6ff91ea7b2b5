#include "engine/decomposition/map_surface.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <set>

#include "engine/decomposition/branch_mapping.h"
#include "engine/decomposition/decompose.h"
#include "engine/decomposition/flooding.h"
#include "tests/support/shapes.h"

namespace ossuary::decomposition {
namespace {

/// Three straight branches that meet at the origin.
skeleton::SkeletonGraph tripod() {
    skeleton::SkeletonGraph graph;
    graph.nodes.resize(4);
    const Vec3 ends[] = {{1, 0, 0}, {-0.5, 0.9, 0}, {-0.5, -0.9, 0}};
    for (std::uint32_t b = 0; b < 3; ++b) {
        graph.nodes[b + 1].position = ends[b];
        skeleton::SkeletonGraph::Branch branch{0, b + 1, {}, {}};
        for (int k = 0; k <= 20; ++k) {
            branch.points.emplace_back(k / 20.0 * ends[b]);
            branch.radii.push_back(0.1);
        }
        graph.branches.push_back(branch);
    }
    return graph;
}

TEST(BranchMapping, FindsTheLeastOfEquation38OverAllVertices) {
    const skeleton::SkeletonGraph skeleton = tripod();
    const BranchMapping mapping(skeleton);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int round = 0; round < 500; ++round) {
        const Vec3 point(unit(random), unit(random), unit(random));
        const Vec3 normal = Vec3(unit(random), unit(random), unit(random)).normalized();
        double least = std::numeric_limits<double>::infinity();
        for (const auto& branch : skeleton.branches) {
            for (const Vec3& vertex : branch.points) {
                const Vec3 n = point - vertex;
                const double facing = n.dot(normal);
                if (facing > 0.0) least = std::min(least, n.norm() / facing * n.norm());
            }
        }
        if (!std::isfinite(least)) continue;
        const auto& found = skeleton.branches[mapping.branch_of(point, normal)];
        double least_of_found = std::numeric_limits<double>::infinity();
        for (const Vec3& vertex : found.points) {
            const Vec3 n = point - vertex;
            const double facing = n.dot(normal);
            if (facing > 0.0) least_of_found = std::min(least_of_found, n.squaredNorm() / facing);
        }
        EXPECT_NEAR(least_of_found, least, 1e-12);
    }
}

TEST(MapSurface, GivesEachLimbItsBranch) {
    const mesh::TriangleMesh mesh = test::capsule_tree_mesh();
    const auto result = decompose(mesh, {.method = DecompositionMethod::kThesis});
    ASSERT_TRUE(result.ok()) << result.error().message;
    EXPECT_EQ(result->segmentation.labels.size(), mesh.triangles.size());
    EXPECT_GE(result->segmentation.parts, 5u);
    EXPECT_LE(result->segmentation.parts, result->skeleton.branches.size());
}

TEST(MapSurface, DependsOnTheSeedAlone) {
    const mesh::TriangleMesh mesh = test::capsule_tree_mesh();
    const auto once = decompose(mesh, {.method = DecompositionMethod::kThesis, .seed = 5});
    const auto twice = decompose(mesh, {.method = DecompositionMethod::kThesis, .seed = 5});
    EXPECT_EQ(once->segmentation, twice->segmentation);
    const skeleton::SkeletonGraph skeleton = tripod();
    const mesh::TriangleMesh ball = test::icosphere_mesh(Vec3::Zero(), 1.0, 4);
    EXPECT_NE(map_surface(ball, skeleton, {.seed = 1}), map_surface(ball, skeleton, {.seed = 2}));
}

TEST(MapSurface, MapsEverythingToOnePartWhereTheSkeletonIsAPoint) {
    const mesh::TriangleMesh ball = test::icosphere_mesh(Vec3::Zero(), 1.0, 3);
    const auto labels = map_surface(ball, skeleton::SkeletonGraph{});
    EXPECT_EQ(std::set<std::uint32_t>(labels.begin(), labels.end()).size(), 1u);
}

TEST(MapSurface, RefusesANumberOfParts) {
    const auto result =
        decompose(test::capsule_tree_mesh(), {.method = DecompositionMethod::kThesis, .parts = 3});
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, ErrorCode::kInvalidArgument);
}

TEST(FloodLabels, DecidesACollisionByTheCloserNormal) {
    // A roof with the ridge at x = 0: of the vertices on the ridge's two sides, the one at x = .1
    // faces as the right side does although the left is as near by edges.
    VertexGraph chain;
    chain.first = {0, 1, 3, 4};
    chain.neighbors = {1, 0, 2, 1};
    chain.normals = {Vec3(-1, 0, 1).normalized(), Vec3(1, 0, 1.1).normalized(),
                     Vec3(1, 0, 1).normalized()};
    chain.curvatures = {0, 0, 0};
    std::vector<std::uint32_t> labels = {7, kUnlabeled, 9};
    flood_labels(chain, labels);
    EXPECT_EQ(labels, (std::vector<std::uint32_t>{7, 9, 9}));
}

TEST(FloodLabels, LeavesWhatNoLabelReaches) {
    VertexGraph two;
    two.first = {0, 0, 0};
    two.normals = {Vec3::UnitZ(), Vec3::UnitZ()};
    two.curvatures = {0, 0};
    std::vector<std::uint32_t> labels = {3, kUnlabeled};
    flood_labels(two, labels);
    EXPECT_EQ(labels, (std::vector<std::uint32_t>{3, kUnlabeled}));
}

}  // namespace
}  // namespace ossuary::decomposition
