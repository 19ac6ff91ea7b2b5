#include "engine/decomposition/rig.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "engine/decomposition/decompose.h"
#include "tests/support/shapes.h"

namespace ossuary::decomposition {
namespace {

TEST(Rig, HasAJointForEachBranchAndOneToHoldThem) {
    const mesh::TriangleMesh mesh = test::capsule_tree_mesh();
    const auto decomposition = decompose(mesh);
    ASSERT_TRUE(decomposition.ok());
    const Rig rig = make_rig(mesh, decomposition->skeleton);
    EXPECT_EQ(rig.joints[0].parent, -1);
    std::vector<bool> seen(decomposition->skeleton.branches.size(), false);
    for (std::size_t k = 1; k < rig.joints.size(); ++k) {
        EXPECT_GE(rig.joints[k].parent, 0);
        EXPECT_LT(rig.joints[k].parent, static_cast<std::int32_t>(k));
        if (rig.joints[k].branch < 0) continue;
        const auto branch = static_cast<std::size_t>(rig.joints[k].branch);
        EXPECT_FALSE(seen[branch]) << branch << " has two joints";
        seen[branch] = true;
    }
    EXPECT_EQ(std::count(seen.begin(), seen.end(), false), 0);
}

TEST(Rig, HasATipAtEachEndOfTheSkeletonThatNothingFollows) {
    const mesh::TriangleMesh mesh = test::capsule_tree_mesh();
    const skeleton::SkeletonGraph skeleton = decompose(mesh)->skeleton;
    const Rig rig = make_rig(mesh, skeleton);
    std::set<std::size_t> tips;
    for (std::size_t k = 1; k < rig.joints.size(); ++k) {
        if (rig.joints[k].branch >= 0) continue;
        tips.insert(k);
        const auto at_tip = [&](const skeleton::SkeletonGraph::Node& node) {
            return node.position == rig.joints[k].position;
        };
        EXPECT_TRUE(std::any_of(skeleton.nodes.begin(), skeleton.nodes.end(), at_tip));
    }
    std::vector<int> degree(skeleton.nodes.size(), 0);
    for (const auto& branch : skeleton.branches) {
        ++degree[branch.a];
        ++degree[branch.b];
    }
    EXPECT_EQ(static_cast<std::ptrdiff_t>(tips.size()),
              std::count(degree.begin(), degree.end(), 1));
    for (const Rig::Weights& weights : rig.weights) {
        for (std::size_t k = 0; k < Rig::kInfluences; ++k) {
            if (weights.weights[k] > 0.0F) {
                EXPECT_FALSE(tips.contains(weights.joints[k]));
            }
        }
    }
}

TEST(Rig, WeighsEveryVertexByOneInAll) {
    const mesh::TriangleMesh mesh = test::capsule_tree_mesh();
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
    const mesh::TriangleMesh ball = test::icosphere_mesh(Vec3::Zero(), 1.0, 2);
    const Rig rig = make_rig(ball, skeleton::SkeletonGraph{});
    EXPECT_EQ(rig.joints.size(), 1u);
    for (const Rig::Weights& weights : rig.weights) EXPECT_EQ(weights.weights[0], 1.0F);
}

}  // namespace
}  // namespace ossuary::decomposition
