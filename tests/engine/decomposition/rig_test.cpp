#include "engine/decomposition/rig.h"

#include <gtest/gtest.h>

#include "engine/decomposition/decompose.h"
#include "tests/support/shapes.h"

namespace ossuary {
namespace {

TEST(Rig, HasAJointForEachBranchAndOneToHoldThem) {
    const TriangleMesh mesh = test::capsule_tree_mesh();
    const auto decomposition = decompose(mesh);
    ASSERT_TRUE(decomposition.ok());
    const Rig rig = make_rig(mesh, decomposition->skeleton);
    ASSERT_EQ(rig.joints.size(), decomposition->skeleton.branches.size() + 1);
    EXPECT_EQ(rig.joints[0].parent, -1);
    std::vector<bool> seen(decomposition->skeleton.branches.size(), false);
    for (std::size_t k = 1; k < rig.joints.size(); ++k) {
        EXPECT_GE(rig.joints[k].parent, 0);
        EXPECT_LT(rig.joints[k].parent, static_cast<std::int32_t>(k));
        seen[static_cast<std::size_t>(rig.joints[k].branch)] = true;
    }
    EXPECT_EQ(std::count(seen.begin(), seen.end(), false), 0);
}

TEST(Rig, WeighsEveryVertexByOneInAll) {
    const TriangleMesh mesh = test::capsule_tree_mesh();
    const Rig rig = make_rig(mesh, decompose(mesh)->skeleton);
    ASSERT_EQ(rig.weights.size(), mesh.vertices.size());
    bool any_shared = false;
    for (const Rig::Weights& weights : rig.weights) {
        float sum = 0.0F;
        for (std::size_t k = 0; k < Rig::kInfluences; ++k) {
            sum += weights.weights[k];
            EXPECT_LT(weights.joints[k], rig.joints.size());
            if (k > 0) {
                EXPECT_LE(weights.weights[k], weights.weights[k - 1]);
            }
        }
        EXPECT_NEAR(sum, 1.0F, 1e-5F);
        any_shared = any_shared || weights.weights[1] > 0.1F;
    }
    EXPECT_TRUE(any_shared);
}

TEST(Rig, HoldsModelsWithoutBranchesByOneJoint) {
    const TriangleMesh ball = test::icosphere_mesh(Vec3::Zero(), 1.0, 2);
    const Rig rig = make_rig(ball, SkeletonGraph{});
    EXPECT_EQ(rig.joints.size(), 1u);
    for (const Rig::Weights& weights : rig.weights) EXPECT_EQ(weights.weights[0], 1.0F);
}

}  // namespace
}  // namespace ossuary
