#include "engine/skeleton/skeletonize.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

#include "engine/mesh/read_mesh.h"
#include "engine/voxel/betti.h"
#include "tests/engine/skeleton/count_of_degree.h"
#include "tests/support/benchmark_data.h"
#include "tests/support/shapes.h"

namespace ossuary::skeleton {
namespace {

using test::count_of_degree;

void expect_equal(const SkeletonGraph& a, const SkeletonGraph& b) {
    ASSERT_EQ(a.nodes.size(), b.nodes.size());
    ASSERT_EQ(a.branches.size(), b.branches.size());
    for (std::size_t i = 0; i < a.nodes.size(); ++i) {
        EXPECT_EQ(a.nodes[i].position, b.nodes[i].position);
        EXPECT_EQ(a.nodes[i].significance, b.nodes[i].significance);
    }
    for (std::size_t i = 0; i < a.branches.size(); ++i) {
        EXPECT_EQ(a.branches[i].points, b.branches[i].points);
        EXPECT_EQ(a.branches[i].radii, b.branches[i].radii);
    }
}

TEST(Skeletonize, FindsTheLimbsOfATreeMeshWithBothMethods) {
    const mesh::TriangleMesh mesh = test::capsule_tree_mesh();
    for (const ThinningMethod method : {ThinningMethod::kAnchored, ThinningMethod::kParallel}) {
        SkeletonizeOptions options;
        options.thinning.method = method;
        const auto skeleton = skeletonize(mesh, options);
        ASSERT_TRUE(skeleton.ok()) << skeleton.error().message;
        EXPECT_EQ(topology(skeleton->refined), (GraphTopology{1, 0}));
        EXPECT_EQ(voxel::betti_numbers(skeleton->thinned_volume),
                  voxel::betti_numbers(skeleton->solid.volume));
        if (method == ThinningMethod::kAnchored) {
            EXPECT_EQ(count_of_degree(skeleton->refined, 1), 6);
        }
    }
}

TEST(Skeletonize, FollowsTheModelHoweverItIsTurnedOrMirrored) {
    const mesh::TriangleMesh mesh = test::capsule_tree_mesh();
    const auto original = skeletonize(mesh);
    ASSERT_TRUE(original.ok());
    Mat3 mirror = Mat3::Identity();
    mirror(0, 0) = -1.0;
    for (const Mat3& motion : {test::random_rotation(3), test::random_rotation(4), mirror}) {
        const auto moved = skeletonize(test::transformed(mesh, motion));
        ASSERT_TRUE(moved.ok());
        const SkeletonGraph expected = to_world(original->refined, original->solid.world_from_grid);
        const SkeletonGraph found = to_world(moved->refined, moved->solid.world_from_grid);
        ASSERT_EQ(found.nodes.size(), expected.nodes.size());
        for (std::size_t i = 0; i < found.nodes.size(); ++i) {
            EXPECT_TRUE(found.nodes[i].position.isApprox(motion * expected.nodes[i].position, 1e-3))
                << found.nodes[i].position.transpose();
        }
    }
}

TEST(Skeletonize, TimesItsStages) {
    const auto skeleton = skeletonize(test::torus_mesh(2.0, 0.5));
    ASSERT_TRUE(skeleton.ok());
    constexpr std::array<const char*, 4> kStages = {"voxelize", "distance_transform", "thin",
                                                    "refine"};
    ASSERT_EQ(skeleton->stage_times.size(), kStages.size());
    for (std::size_t i = 0; i < kStages.size(); ++i) {
        EXPECT_EQ(skeleton->stage_times[i].stage, kStages[i]);
        EXPECT_GE(skeleton->stage_times[i].milliseconds, 0.0);
    }
    EXPECT_EQ(topology(skeleton->refined), (GraphTopology{1, 1}));
}

TEST(Skeletonize, StopsWhenAsked) {
    std::stop_source source;
    source.request_stop();
    const auto skeleton = skeletonize(test::torus_mesh(2.0, 0.5), {}, source.get_token());
    ASSERT_FALSE(skeleton.ok());
    EXPECT_EQ(skeleton.error().code, ErrorCode::kCancelled);
}

TEST(Skeletonize, PassesOnTheErrorsOfVoxelization) {
    const auto skeleton = skeletonize(mesh::TriangleMesh{});
    ASSERT_FALSE(skeleton.ok());
    EXPECT_EQ(skeleton.error().code, ErrorCode::kMeshEmpty);
}

TEST(Skeletonize, GivesTheSameSkeletonEachTime) {
    const mesh::TriangleMesh mesh = test::capsule_tree_mesh();
    const auto first = skeletonize(mesh);
    const auto second = skeletonize(mesh);
    ASSERT_TRUE(first.ok() && second.ok());
    EXPECT_EQ(first->thinned_volume, second->thinned_volume);
    expect_equal(first->refined, second->refined);
}

TEST(Skeletonize, KeepsTheTopologyOfBenchmarkModels) {
    OSSUARY_REQUIRE_BENCHMARK_DATA(data);
    // One each of human, cup, octopus, table, hand, armadillo, vase.
    for (const int number : {1, 21, 121, 141, 181, 281, 361}) {
        const auto path =
            data / "princeton-segmentation" / "off" / (std::to_string(number) + ".off");
        const auto model = mesh::read_mesh(path);
        ASSERT_TRUE(model.ok()) << model.error().message;
        for (const ThinningMethod method : {ThinningMethod::kAnchored, ThinningMethod::kParallel}) {
            SCOPED_TRACE(std::to_string(number) + " " + std::string(to_string(method)));
            SkeletonizeOptions options;
            options.voxelize.resolution = 64;
            options.thinning.method = method;
            const auto skeleton = skeletonize(model->mesh, options);
            ASSERT_TRUE(skeleton.ok()) << skeleton.error().message;
            const voxel::BettiNumbers betti = voxel::betti_numbers(skeleton->solid.volume);
            EXPECT_EQ(voxel::betti_numbers(skeleton->thinned_volume), betti);
            if (betti.cavities == 0) {
                const GraphTopology expected{betti.components, betti.tunnels};
                EXPECT_EQ(topology(skeleton->thinned), expected);
                EXPECT_EQ(topology(skeleton->refined), expected);
            }
        }
    }
}

TEST(Skeletonize, FindsFiveLimbsOfAHumanAndEightOfAnOctopus) {
    OSSUARY_REQUIRE_BENCHMARK_DATA(data);
    for (const auto& [number, limbs] : {std::pair{1, 5}, std::pair{121, 8}}) {
        const auto path =
            data / "princeton-segmentation" / "off" / (std::to_string(number) + ".off");
        const auto model = mesh::read_mesh(path);
        ASSERT_TRUE(model.ok()) << model.error().message;
        const auto skeleton = skeletonize(model->mesh);
        ASSERT_TRUE(skeleton.ok()) << skeleton.error().message;
        EXPECT_EQ(count_of_degree(skeleton->refined, 1), limbs) << number;
    }
}

}  // namespace
}  // namespace ossuary::skeleton
