#include "engine/matching/rooted_skeleton.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/engine/matching/built_skeletons.h"

namespace ossuary::matching {
namespace {

double total_length(const SkeletonDescriptor& descriptor) {
    double sum = 0.0;
    for (const auto& branch : descriptor.branches) sum += static_cast<double>(branch.length);
    return sum;
}

double piece_length(const RootedSkeletons& rooted, const RootedTree& tree) {
    double sum = 0.0;
    for (const auto& node : tree.nodes) {
        if (node.piece != kNoIndex) sum += static_cast<double>(rooted.pieces[node.piece].length);
    }
    return sum;
}

void expect_sound(const SkeletonDescriptor& descriptor) {
    const RootedSkeletons& rooted = descriptor.rooted;
    ASSERT_FALSE(rooted.trees.empty());
    for (const RootedTree& tree : rooted.trees) {
        ASSERT_EQ(tree.merged.size(), tree.nodes.size());
        // Every node of the graph hangs somewhere, once, and no length is lost.
        std::multiset<std::uint32_t> hung;
        for (std::uint32_t i = 0; i < tree.nodes.size(); ++i) {
            const RootedTree::Node& node = tree.nodes[i];
            EXPECT_EQ(rooted.merged.nodes[tree.merged[i]].piece, node.piece);
            EXPECT_EQ(rooted.merged.nodes[tree.merged[i]].weight, node.weight);
            if (node.graph_node != kNoIndex) hung.insert(node.graph_node);
            if (node.parent == kNoIndex) {
                EXPECT_EQ(i + 1, tree.nodes.size());
            } else {
                EXPECT_GT(node.parent, i);
                const auto below = rooted.merged.shape.children(tree.merged[node.parent]);
                EXPECT_EQ(std::count(below.begin(), below.end(), tree.merged[i]), 1);
            }
        }
        EXPECT_EQ(hung.size(), descriptor.nodes.size());
        EXPECT_EQ(std::set<std::uint32_t>(hung.begin(), hung.end()).size(), hung.size());
        EXPECT_NEAR(piece_length(rooted, tree), total_length(descriptor), 1e-4);
    }
}

TEST(RootedSkeleton, KeepsEveryNodeAndAllLengthOfAnySkeleton) {
    std::mt19937 random(61);
    for (const skeleton::SkeletonGraph& graph :
         {test::human(0.3), test::four_leg(0.6), test::octopus(0.2), test::curve(), test::ring(),
          test::cup(), test::figure_eight(), test::two_components(), test::point()}) {
        expect_sound(test::describe(graph));
    }
    for (int round = 0; round < 50; ++round) {
        expect_sound(test::describe(test::random_skeleton(random, 2 + round % 15, round % 4)));
    }
}

TEST(RootedSkeleton, OfNothingHasNoTrees) {
    EXPECT_TRUE(test::describe(skeleton::SkeletonGraph{}).rooted.trees.empty());
}

TEST(RootedSkeleton, HangsAnOctopusUpAtItsBody) {
    const SkeletonDescriptor octopus = test::describe(test::octopus(0.5));
    ASSERT_EQ(octopus.rooted.trees.size(), 1U);
    EXPECT_EQ(octopus.rooted.trees[0].nodes.back().graph_node, 0U);
    for (std::size_t arm = 0; arm < 8; ++arm) {
        EXPECT_EQ(octopus.rooted.trees[0].nodes[arm].parent, 8U);
    }
}

TEST(RootedSkeleton, OffersBothEndsOfATrunkAsRoots) {
    const SkeletonDescriptor animal = test::describe(test::four_leg(0.5));
    ASSERT_EQ(animal.rooted.trees.size(), 2U);
    std::set<std::uint32_t> roots;
    for (const auto& tree : animal.rooted.trees) roots.insert(tree.nodes.back().graph_node);
    EXPECT_EQ(roots, (std::set<std::uint32_t>{0U, 1U}));
}

TEST(RootedSkeleton, CutsACycleAtThePointAsFarBothWays) {
    const SkeletonDescriptor ring = test::describe(test::ring());
    for (const RootedTree& tree : ring.rooted.trees) {
        ASSERT_EQ(tree.nodes.size(), 3U);
        EXPECT_EQ(tree.nodes[0].graph_node, kNoIndex);
        EXPECT_EQ(tree.nodes[1].graph_node, kNoIndex);
        EXPECT_NEAR(tree.nodes[0].weight, tree.nodes[1].weight, 1e-6F);
    }
    const SkeletonDescriptor cup = test::describe(test::cup());
    for (const RootedTree& tree : cup.rooted.trees) {
        float halves[2] = {0.0F, 0.0F};
        std::size_t count = 0;
        for (const RootedTree::Node& node : tree.nodes) {
            if (node.graph_node != kNoIndex || count == 2) continue;
            halves[count++] = node.root_distance + node.weight;
        }
        ASSERT_EQ(count, 2U);
        EXPECT_NEAR(halves[0], halves[1], 1e-5F);
    }
}

TEST(RootedSkeleton, SharesThePiecesThatBothTreesWalkTheSameWay) {
    const SkeletonDescriptor animal = test::describe(test::four_leg(0.5));
    // Only the trunk is walked both ways.
    EXPECT_EQ(animal.rooted.pieces.size(), animal.branches.size() + 1);
    // Merged: all seven branches, the trunk a second time, and two roots.
    EXPECT_EQ(animal.rooted.merged.nodes.size(), animal.branches.size() + 3);
}

TEST(RootedSkeleton, MeasuresRootDistancesAlongTheBranches) {
    const SkeletonDescriptor animal = test::describe(test::four_leg(0.0));
    for (const RootedTree& tree : animal.rooted.trees) {
        for (const RootedTree::Node& node : tree.nodes) {
            if (node.parent == kNoIndex) continue;
            const RootedTree::Node& parent = tree.nodes[node.parent];
            const float expected =
                parent.parent == kNoIndex ? 0.0F : parent.root_distance + parent.weight;
            EXPECT_NEAR(node.root_distance, expected, 1e-5F);
        }
    }
}

TEST(RootedSkeleton, LeavesTheShortestLeavesOfAnOvergrownSkeletonOut) {
    std::mt19937 random(62);
    SkeletonDescriptor descriptor = test::describe(test::random_skeleton(random, 60, 5));
    RootingOptions options;
    options.max_pieces = 20;
    derive_matching_data(descriptor, options);
    for (const RootedTree& tree : descriptor.rooted.trees) {
        EXPECT_EQ(tree.nodes.size(), 21U);
        EXPECT_EQ(tree.merged.size(), 21U);
    }
}

TEST(RootedSkeleton, FollowsFromTheStoredFieldsAloneBitByBit) {
    std::mt19937 random(63);
    const SkeletonDescriptor made = test::describe(test::random_skeleton(random, 20, 3));
    SkeletonDescriptor loaded;
    loaded.nodes = made.nodes;
    loaded.branches = made.branches;
    derive_matching_data(loaded);
    EXPECT_EQ(loaded.rooted.content_key, made.rooted.content_key);
    EXPECT_EQ(loaded.rooted.steps, made.rooted.steps);
    ASSERT_EQ(loaded.rooted.trees.size(), made.rooted.trees.size());
    for (std::size_t t = 0; t < made.rooted.trees.size(); ++t) {
        const RootedTree& x = loaded.rooted.trees[t];
        const RootedTree& y = made.rooted.trees[t];
        EXPECT_EQ(x.total_weight, y.total_weight);
        ASSERT_EQ(x.nodes.size(), y.nodes.size());
        for (std::size_t i = 0; i < x.nodes.size(); ++i) {
            EXPECT_EQ(x.nodes[i].root_distance, y.nodes[i].root_distance);
            EXPECT_EQ(x.nodes[i].piece, y.nodes[i].piece);
        }
    }
}

}  // namespace
}  // namespace ossuary::matching
