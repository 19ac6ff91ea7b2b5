#include "engine/descriptor/describe.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/descriptor/global_descriptors.h"
#include "engine/descriptor/signature.h"
#include "engine/mesh/read_mesh.h"
#include "tests/support/benchmark_data.h"
#include "tests/support/shapes.h"

namespace ossuary::descriptor {
namespace {

/// Every number is finite and the parts have their fixed lengths.
void expect_whole(const Description& description, const std::string& name) {
    ASSERT_EQ(description.descriptor.globals.size(), kGlobalDescriptorKinds.size()) << name;
    for (std::size_t k = 0; k < kGlobalDescriptorKinds.size(); ++k) {
        const auto& global = description.descriptor.globals[k];
        ASSERT_EQ(global.values.size(), kGlobalDescriptorKinds[k].size) << name;
    }
    const float volume = description.descriptor.skeleton.solid_volume;
    ASSERT_TRUE(volume > 0.0F && volume < 0.1F) << name << " " << volume;
    const float limbs = description.descriptor.skeleton.limb_volume;
    ASSERT_TRUE(limbs >= 0.0F && limbs < 0.2F) << name << " " << limbs;
    ASSERT_EQ(description.descriptor.signature.size(), kSignatureSize) << name;
    for (const auto& node : description.skeleton.nodes) {
        ASSERT_TRUE(node.position.allFinite() && std::isfinite(node.radius)) << name;
    }
    for (const auto& branch : description.descriptor.skeleton.branches) {
        ASSERT_TRUE(std::isfinite(branch.length)) << name;
    }
}

TEST(Describe, DescribesBuiltShapesAndRaggedOnes) {
    const mesh::TriangleMesh torus = test::torus_mesh(1.0, 0.3);
    const std::vector<std::pair<std::string, mesh::TriangleMesh>> meshes = {
        {"torus", torus},
        {"tree", test::capsule_tree_mesh()},
        {"open box", test::open_box_mesh(Vec3::Zero(), Vec3(1, 2, 3))},
        {"holes", test::without_some_triangles(torus, 0.2, 3)},
        {"two pieces", test::merged(torus, test::icosphere_mesh(Vec3(9, 0, 0), 0.5))},
        {"inside out", test::flipped(torus)}};
    for (const auto& [name, mesh] : meshes) {
        const auto description = describe(mesh);
        ASSERT_TRUE(description.ok()) << name << ": " << description.error().message;
        expect_whole(*description, name);
        EXPECT_EQ(description->descriptor.skeleton.branches.size(),
                  description->skeleton.branches.size())
            << name;
    }
}

TEST(Describe, ReturnsTheSkeletonInTheModelsOwnUnits) {
    const Vec3 offset(1000.0, -50.0, 3.0);
    const mesh::TriangleMesh mesh =
        test::transformed(test::torus_mesh(10.0, 3.0), Mat3::Identity(), offset);
    const auto description = describe(mesh);
    ASSERT_TRUE(description.ok());
    ASSERT_FALSE(description->skeleton.branches.empty());
    for (const auto& branch : description->skeleton.branches) {
        for (const Vec3& point : branch.points) {
            const Vec3 local = point - offset;
            EXPECT_NEAR(std::hypot(local.x(), local.y()), 10.0, 1.5);
            EXPECT_NEAR(local.z(), 0.0, 1.0);
        }
        for (const double radius : branch.radii) EXPECT_NEAR(radius, 3.0, 0.8);
    }
}

TEST(Describe, NamesItsStagesInOrder) {
    const auto description = describe(test::torus_mesh(1.0, 0.3));
    ASSERT_TRUE(description.ok());
    std::vector<std::string> stages;
    for (const StageTime& time : description->stage_times) {
        stages.push_back(time.stage);
        EXPECT_GE(time.milliseconds, 0.0);
    }
    const std::vector<std::string> tail = {"surface", "describe_skeleton", "turned_skeletons",
                                           "global_descriptors", "signature"};
    ASSERT_GE(stages.size(), tail.size());
    EXPECT_TRUE(std::equal(tail.rbegin(), tail.rend(), stages.rbegin()));
}

TEST(Describe, IsTheSameEveryTime) {
    const mesh::TriangleMesh mesh = test::capsule_tree_mesh();
    const auto a = describe(mesh), b = describe(mesh);
    ASSERT_TRUE(a.ok() && b.ok());
    EXPECT_EQ(a->descriptor.signature, b->descriptor.signature);
    for (std::size_t k = 0; k < a->descriptor.globals.size(); ++k) {
        EXPECT_EQ(a->descriptor.globals[k].values, b->descriptor.globals[k].values);
    }
    EXPECT_EQ(a->descriptor.skeleton.rooted.content_key, b->descriptor.skeleton.rooted.content_key);
}

/// All that the index keeps of two descriptions is the same, bit by bit.
void expect_same(const Description& a, const Description& b) {
    EXPECT_EQ(a.descriptor.signature, b.descriptor.signature);
    ASSERT_EQ(a.descriptor.globals.size(), b.descriptor.globals.size());
    for (std::size_t k = 0; k < a.descriptor.globals.size(); ++k) {
        EXPECT_EQ(a.descriptor.globals[k].name, b.descriptor.globals[k].name);
        EXPECT_EQ(a.descriptor.globals[k].values, b.descriptor.globals[k].values);
    }
    EXPECT_EQ(a.descriptor.skeleton.rooted.content_key, b.descriptor.skeleton.rooted.content_key);
    ASSERT_EQ(a.skeleton.branches.size(), b.skeleton.branches.size());
    for (std::size_t i = 0; i < a.skeleton.branches.size(); ++i) {
        EXPECT_EQ(a.skeleton.branches[i].points, b.skeleton.branches[i].points);
        EXPECT_EQ(a.skeleton.branches[i].radii, b.skeleton.branches[i].radii);
    }
    EXPECT_EQ(a.warnings.size(), b.warnings.size());
}

TEST(Describe, IsTheSameForEveryNumberOfJobs) {
    const mesh::TriangleMesh torus = test::torus_mesh(1.0, 0.3);
    for (const auto& mesh : {test::capsule_tree_mesh(), test::without_some_triangles(torus, 0.2, 3),
                             // A speck that is left out: what is described is not the whole mesh.
                             test::merged(torus, test::icosphere_mesh(Vec3(40, 0, 0), 0.01))}) {
        const auto alone = describe(mesh);
        ASSERT_TRUE(alone.ok()) << alone.error().message;
        for (const int jobs : {0, 2, 7}) {
            DescribeOptions options;
            options.jobs = jobs;
            const auto together = describe(mesh, options);
            ASSERT_TRUE(together.ok()) << together.error().message;
            expect_same(*alone, *together);
            EXPECT_EQ(alone->body.pieces_apart, together->body.pieces_apart);
        }
    }
}

TEST(Describe, AveragesOverAsManyTurnedGridsAsAreAskedFor) {
    const mesh::TriangleMesh mesh = test::capsule_tree_mesh();
    std::vector<ModelDescriptor> descriptors;
    for (int grids = 0; grids <= kMaxTurnedGrids; ++grids) {
        DescribeOptions options;
        options.turned_grids = grids;
        const auto description = describe(mesh, options);
        ASSERT_TRUE(description.ok());
        descriptors.push_back(description->descriptor);
    }
    for (std::size_t i = 1; i < descriptors.size(); ++i) {
        // What is matched comes from the first grid alone.
        EXPECT_EQ(descriptors[i].skeleton.rooted.content_key,
                  descriptors[0].skeleton.rooted.content_key);
        for (const std::size_t place : {kSkeletonPairsPlace, kSkeletonLayoutPlace}) {
            EXPECT_NE(descriptors[i].globals[place].values,
                      descriptors[i - 1].globals[place].values);
        }
        EXPECT_EQ(descriptors[i].globals[kViewsPlace].values,
                  descriptors[0].globals[kViewsPlace].values);
    }
}

TEST(Describe, StopsWhenAsked) {
    std::stop_source source;
    source.request_stop();
    const auto description = describe(test::torus_mesh(1.0, 0.3), {}, source.get_token());
    ASSERT_FALSE(description.ok());
    EXPECT_EQ(description.error().code, ErrorCode::kCancelled);
}

TEST(Describe, RefusesWhatHasNoBody) {
    const auto empty = describe(mesh::TriangleMesh{});
    ASSERT_FALSE(empty.ok());
    EXPECT_EQ(empty.error().code, ErrorCode::kMeshEmpty);
}

TEST(Describe, DescribesModelsOfBothCollections) {
    OSSUARY_REQUIRE_BENCHMARK_DATA(data);
    for (const char* file :
         {"princeton-segmentation/off/1.off", "princeton-segmentation/off/25.off",
          "princeton-segmentation/off/281.off", "princeton-shape-train/off/m1298.off",
          "princeton-shape-train/off/m1118.off"}) {
        const auto read = mesh::read_mesh(data / file);
        ASSERT_TRUE(read.ok()) << file;
        const auto description = describe(read->mesh);
        ASSERT_TRUE(description.ok()) << file << ": " << description.error().message;
        expect_whole(*description, file);
    }
}

}  // namespace
}  // namespace ossuary::descriptor
