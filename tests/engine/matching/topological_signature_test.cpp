#include "engine/matching/topological_signature.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/engine/matching/built_skeletons.h"

namespace ossuary::matching {
namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFFU;

TEST(EigenvalueSum, OfAStarIsTwiceTheSquareRootOfItsRays) {
    // The eigenvalues of a star with n rays are sqrt(n), -sqrt(n) and zeros.
    for (std::uint32_t rays = 2; rays < 7; ++rays) {
        std::vector<std::uint32_t> parents(rays, rays);
        parents.push_back(kNone);
        EXPECT_NEAR(eigenvalue_sum(tree_shape(parents), rays, 96), 2.0 * std::sqrt(rays), 1e-9);
    }
}

TEST(EigenvalueSum, CountsAsManyEigenvaluesAsTheRootHasChildren) {
    // A path of three hung up at its end: eigenvalues sqrt(2), 0, -sqrt(2); one child.
    const TreeShape path = tree_shape(std::vector<std::uint32_t>{1, 2, kNone});
    EXPECT_NEAR(eigenvalue_sum(path, 2, 96), std::sqrt(2.0), 1e-9);
    EXPECT_NEAR(eigenvalue_sum(path, 1, 96), 1.0, 1e-9);
    EXPECT_EQ(eigenvalue_sum(path, 0, 96), 0.0);
}

TEST(SignatureTree, IsRootedAtTheMostSignificantNode) {
    const SkeletonDescriptor animal = test::describe(test::four_leg(0.4));
    const SignatureTree& tree = animal.hierarchy;
    ASSERT_EQ(tree.nodes.size(), animal.nodes.size());
    const float most = animal.nodes[tree.nodes.back().graph_node].significance;
    for (const auto& node : animal.nodes) EXPECT_LE(node.significance, most);
    EXPECT_EQ(tree.nodes.back().rank, 0U);
}

TEST(SignatureTree, KeepsSubtreesTogetherAndSignsInnerNodesOnly) {
    std::mt19937 random(71);
    for (int round = 0; round < 40; ++round) {
        const SkeletonDescriptor d = test::describe(test::random_skeleton(random, 14, round % 3));
        const SignatureTree& tree = d.hierarchy;
        for (std::uint32_t i = 0; i < tree.nodes.size(); ++i) {
            const auto children = tree.shape.children(i);
            EXPECT_EQ(tree.nodes[i].signature.size(), children.empty() ? 0 : children.size() + 1);
            std::uint32_t first = i;
            for (const std::uint32_t child : children) {
                EXPECT_EQ(tree.nodes[child].parent, i);
                first = std::min(first, tree.nodes[child].first_in_subtree);
                const auto& branch = d.branches[tree.nodes[child].parent_branch];
                const std::uint32_t here = tree.nodes[child].graph_node;
                const std::uint32_t above = tree.nodes[i].graph_node;
                EXPECT_TRUE((branch.a == here && branch.b == above) ||
                            (branch.b == here && branch.a == above));
            }
            EXPECT_EQ(tree.nodes[i].first_in_subtree, first);
            for (std::size_t k = 2; k < tree.nodes[i].signature.size(); ++k) {
                EXPECT_GE(tree.nodes[i].signature[k - 1], tree.nodes[i].signature[k]);
            }
        }
    }
}

TEST(SignatureTree, HangsOtherComponentsBelowTheRootWithoutABranch) {
    const SkeletonDescriptor d = test::describe(test::two_components());
    std::size_t without_branch = 0;
    for (const auto& node : d.hierarchy.nodes)
        without_branch += node.parent_branch == kNone ? 1 : 0;
    EXPECT_EQ(without_branch, 3U);
}

}  // namespace
}  // namespace ossuary::matching
