#include "engine/matching/match_chain_codes.h"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "tests/engine/matching/built_skeletons.h"

namespace ossuary::matching {
namespace {

using test::describe;

double chain_code_distance(const SkeletonDescriptor& a, const SkeletonDescriptor& b,
                           const ChainCodeMatchOptions& options = {}) {
    ChainCodeMatchWorkspace workspace;
    return chain_code_distance(a, b, options, workspace);
}

TEST(MatchChainCodes, GivesZeroForASkeletonAndItself) {
    for (const auto& skeleton : test::many_skeletons(91))
        EXPECT_EQ(chain_code_distance(skeleton, skeleton), 0.0);
}

TEST(MatchChainCodes, IsSymmetricBitByBitAndInTheUnitRange) {
    const auto all = test::many_skeletons(91);
    for (const auto& a : all) {
        for (const auto& b : all) {
            EXPECT_EQ(chain_code_distance(a, b), chain_code_distance(b, a));
            EXPECT_GE(chain_code_distance(a, b), 0.0);
            EXPECT_LE(chain_code_distance(a, b), 1.0);
        }
    }
}

TEST(MatchChainCodes, DoesNotDependOnNumberingDirectionOrAWholeVoxelShift) {
    std::mt19937 random(92);
    const SkeletonDescriptor other = describe(test::human(0.4));
    for (int round = 0; round < 300; ++round) {
        const skeleton::SkeletonGraph graph = test::random_skeleton(random, 12, 0);
        const SkeletonDescriptor first = describe(graph);
        const SkeletonDescriptor second = describe(
            test::renumbered(test::moved(graph, Mat3::Identity(), Vec3(8, -16, 32), 1.0), random));
        EXPECT_EQ(chain_code_distance(first, second), 0.0);
        EXPECT_NEAR(chain_code_distance(first, other), chain_code_distance(second, other), 1e-12);
    }
}

TEST(MatchChainCodes, IsTheMeanOverMatchedAndLeftOverBranches) {
    const auto all = test::many_skeletons(91);
    for (const auto& a : all) {
        for (const auto& b : all) {
            const Match match = match_chain_codes(a, b);
            EXPECT_EQ(match.distance, chain_code_distance(a, b));
            const auto& branches = match.correspondence.branches;
            if (a.branches.size() + b.branches.size() == 0) continue;
            double sum = 0.0;
            for (const auto& pair : branches) sum += pair.cost;
            const auto left_over =
                static_cast<double>(a.branches.size() + b.branches.size() - 2 * branches.size());
            const double count = static_cast<double>(branches.size()) + left_over;
            EXPECT_NEAR(match.distance, (sum + left_over) / count, 1e-12);
            ChainCodeMatchOptions summed;
            summed.sum = true;
            EXPECT_NEAR(chain_code_distance(a, b, summed), sum + left_over, 1e-12);
        }
    }
}

TEST(MatchChainCodes, MatchesBranchesWhoseBothEndsAreMatched) {
    const auto all = test::many_skeletons(91);
    for (const auto& a : all) {
        for (const auto& b : all) {
            const Correspondence c = match_chain_codes(a, b).correspondence;
            std::set<std::uint32_t> used_a, used_b, nodes_a, nodes_b;
            std::set<std::pair<std::uint32_t, std::uint32_t>> nodes;
            for (const auto& pair : c.nodes) {
                nodes.emplace(pair.a, pair.b);
                EXPECT_TRUE(nodes_a.insert(pair.a).second);
                EXPECT_TRUE(nodes_b.insert(pair.b).second);
            }
            for (const auto& pair : c.branches) {
                EXPECT_TRUE(used_a.insert(pair.a).second);
                EXPECT_TRUE(used_b.insert(pair.b).second);
                const auto& x = a.branches[pair.a];
                const auto& y = b.branches[pair.b];
                EXPECT_TRUE((nodes.contains({x.a, y.a}) && nodes.contains({x.b, y.b})) ||
                            (nodes.contains({x.a, y.b}) && nodes.contains({x.b, y.a})));
            }
            EXPECT_EQ(
                std::accumulate(c.cluster_sizes.begin(), c.cluster_sizes.end(), std::size_t{0}),
                c.nodes.size());
        }
    }
}

TEST(MatchChainCodes, MatchesAllLimbsOfTwoPoses) {
    const auto a = describe(test::human(0.2));
    const auto b = describe(test::human(0.7));
    const Correspondence c = match_chain_codes(a, b).correspondence;
    EXPECT_EQ(c.nodes.size(), a.nodes.size());
    EXPECT_EQ(c.branches.size(), a.branches.size());
    EXPECT_EQ(c.cluster_sizes, std::vector<std::uint32_t>{7U});
}

TEST(MatchChainCodes, PutsPosesOfOneBodyCloserThanAnotherBody) {
    const auto standing = describe(test::human(0.3));
    const auto waving = describe(test::human(0.5));
    const auto animal = describe(test::four_leg(0.4));
    EXPECT_LT(chain_code_distance(standing, waving), chain_code_distance(standing, animal));
}

}  // namespace
}  // namespace ossuary::matching
