#include "engine/matching/match_skeletons.h"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "tests/engine/matching/built_skeletons.h"

namespace ossuary::matching {
namespace {

using test::describe;

double skeleton_distance(const SkeletonDescriptor& a, const SkeletonDescriptor& b,
                         const SkeletonMatchOptions& options = {}) {
    SkeletonMatchWorkspace workspace;
    return skeleton_distance(a, b, options, workspace);
}

TEST(MatchSkeletons, GivesZeroForASkeletonAndItselfOnly) {
    const auto all = test::many_skeletons(81);
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(skeleton_distance(all[i], all[i]), 0.0);
        for (std::size_t j = 0; j < i; ++j) EXPECT_GT(skeleton_distance(all[i], all[j]), 1e-4);
    }
}

TEST(MatchSkeletons, IsSymmetricBitByBitAndBounded) {
    const auto all = test::many_skeletons(81);
    for (const auto& a : all) {
        for (const auto& b : all) {
            EXPECT_EQ(skeleton_distance(a, b), skeleton_distance(b, a));
            EXPECT_GE(skeleton_distance(a, b), 0.0);
            EXPECT_LE(skeleton_distance(a, b), 1.0);
        }
    }
}

TEST(MatchSkeletons, GivesTheFastDistanceBitByBitAndPartsThatAddUpToIt) {
    const auto all = test::many_skeletons(81);
    SkeletonMatchWorkspace workspace;
    for (const auto& a : all) {
        for (const auto& b : all) {
            const Match match = match_skeletons(a, b);
            EXPECT_EQ(match.distance, skeleton_distance(a, b, {}, workspace));
            double sum = 0.0;
            for (const DistancePart& part : match.parts) {
                EXPECT_GE(part.value, 0.0);
                sum += part.value;
            }
            EXPECT_NEAR(sum, match.distance, 1e-5);
        }
    }
}

TEST(MatchSkeletons, DoesNotDependOnNumberingOrDirectionOfBranches) {
    std::mt19937 random(82);
    const SkeletonDescriptor other = describe(test::human(0.4));
    for (int round = 0; round < 40; ++round) {
        const skeleton::SkeletonGraph graph = round % 2 == 0
                                                  ? test::four_leg(0.05 * round)
                                                  : test::random_skeleton(random, 12, round % 3);
        const SkeletonDescriptor first = describe(graph);
        const SkeletonDescriptor second = describe(test::renumbered(graph, random));
        EXPECT_NEAR(skeleton_distance(first, second), 0.0, 2e-3);
        EXPECT_NEAR(skeleton_distance(first, other), skeleton_distance(second, other), 2e-3);
    }
}

TEST(MatchSkeletons, DoesNotDependOnPlaceSizeOrMirroring) {
    std::mt19937 random(83);
    const SkeletonDescriptor other = describe(test::human(0.4));
    const Mat3 turn = Eigen::AngleAxisd(1.1, Vec3(1, 2, -1).normalized()).toRotationMatrix();
    const Mat3 mirror = Vec3(-1, 1, 1).asDiagonal();
    for (int round = 0; round < 30; ++round) {
        const skeleton::SkeletonGraph graph = test::random_skeleton(random, 12, round % 3);
        const SkeletonDescriptor first = describe(graph);
        const double scale = 0.3 + 0.1 * round;
        for (const Mat3& linear : {Mat3(Mat3::Identity()), turn, mirror}) {
            const SkeletonDescriptor second =
                describe(test::moved(graph, linear, Vec3(7, -30, 2), scale), 100.0 * scale);
            EXPECT_NEAR(skeleton_distance(first, second), 0.0, 2e-3);
            EXPECT_NEAR(skeleton_distance(first, other), skeleton_distance(second, other), 2e-3);
        }
    }
}

TEST(MatchSkeletons, PutsPosesOfOneBodyCloserThanAnotherBody) {
    const double poses[] = {0.0, 0.3, 0.6, 1.0};
    double farthest_within = 0.0, nearest_across = 1.0;
    for (const double p : poses) {
        for (const double q : poses) {
            const auto people =
                skeleton_distance(describe(test::human(p)), describe(test::human(q)));
            const auto animals =
                skeleton_distance(describe(test::four_leg(p)), describe(test::four_leg(q)));
            farthest_within = std::max({farthest_within, people, animals});
            nearest_across =
                std::min(nearest_across,
                         skeleton_distance(describe(test::human(p)), describe(test::four_leg(q))));
        }
    }
    EXPECT_LT(2.0 * farthest_within, nearest_across);
}

TEST(MatchSkeletons, CountsDirectionsAsMuchAsPoseSays) {
    const SkeletonDescriptor stretched = describe(test::octopus(0.0));
    const SkeletonDescriptor bent = describe(test::octopus(1.0));
    SkeletonMatchOptions options;
    options.pose = 0.0;
    const double build = skeleton_distance(stretched, bent, options);
    options.pose = 1.0;
    EXPECT_GT(skeleton_distance(stretched, bent, options), build);
}

TEST(MatchSkeletons, FindsTheLimbsOfARenumberedAnimal) {
    std::mt19937 random(84);
    const skeleton::SkeletonGraph graph = test::random_skeleton(random, 15, 0);
    const skeleton::SkeletonGraph copy = test::renumbered(graph, random);
    const Match match = match_skeletons(describe(graph), describe(copy));
    EXPECT_EQ(match.correspondence.nodes.size(), graph.nodes.size());
    EXPECT_EQ(match.correspondence.branches.size(), graph.branches.size());
    for (const auto& pair : match.correspondence.nodes) {
        EXPECT_EQ(graph.nodes[pair.a].position, copy.nodes[pair.b].position);
    }
    ASSERT_EQ(match.correspondence.cluster_sizes.size(), 1U);
    EXPECT_EQ(match.correspondence.cluster_sizes[0], graph.nodes.size());
}

void expect_consistent(const SkeletonDescriptor& a, const SkeletonDescriptor& b,
                       const Correspondence& c, bool trees_only) {
    std::set<std::uint32_t> nodes_a, nodes_b;
    std::set<std::pair<std::uint32_t, std::uint32_t>> nodes;
    for (const auto& pair : c.nodes) {
        ASSERT_LT(pair.a, a.nodes.size());
        ASSERT_LT(pair.b, b.nodes.size());
        EXPECT_TRUE(nodes_a.insert(pair.a).second) << "a node has one partner";
        EXPECT_TRUE(nodes_b.insert(pair.b).second) << "a node has one partner";
        nodes.emplace(pair.a, pair.b);
    }
    std::set<std::pair<std::uint32_t, std::uint32_t>> branches;
    for (const auto& pair : c.branches) {
        ASSERT_LT(pair.a, a.branches.size());
        ASSERT_LT(pair.b, b.branches.size());
        EXPECT_TRUE(branches.emplace(pair.a, pair.b).second);
        if (!trees_only) continue;
        // The end of a matched branch that lies away from the root is matched with the other's.
        const auto& x = a.branches[pair.a];
        const auto& y = b.branches[pair.b];
        EXPECT_TRUE(nodes.contains({x.a, y.a}) || nodes.contains({x.a, y.b}) ||
                    nodes.contains({x.b, y.a}) || nodes.contains({x.b, y.b}));
    }
    EXPECT_EQ(std::accumulate(c.cluster_sizes.begin(), c.cluster_sizes.end(), std::size_t{0}),
              c.nodes.size());
    EXPECT_TRUE(std::is_sorted(c.cluster_sizes.rbegin(), c.cluster_sizes.rend()));
}

TEST(MatchSkeletons, NamesConsistentCorrespondences) {
    const auto all = test::many_skeletons(81);
    for (const auto& a : all) {
        for (const auto& b : all) {
            expect_consistent(a, b, match_skeletons(a, b).correspondence, false);
        }
    }
    std::mt19937 random(85);
    for (int round = 0; round < 60; ++round) {
        const auto a = describe(test::random_skeleton(random, 2 + round % 13, 0));
        const auto b = describe(test::random_skeleton(random, 2 + round % 11, 0));
        expect_consistent(a, b, match_skeletons(a, b).correspondence, true);
    }
}

TEST(MatchSkeletons, SwapsTheCorrespondenceWithTheArguments) {
    const auto a = describe(test::human(0.2));
    const auto b = describe(test::four_leg(0.5));
    const Match there = match_skeletons(a, b);
    const Match back = match_skeletons(b, a);
    ASSERT_EQ(there.correspondence.nodes.size(), back.correspondence.nodes.size());
    for (std::size_t i = 0; i < there.correspondence.nodes.size(); ++i) {
        EXPECT_EQ(there.correspondence.nodes[i].a, back.correspondence.nodes[i].b);
        EXPECT_EQ(there.correspondence.nodes[i].b, back.correspondence.nodes[i].a);
    }
    EXPECT_EQ(there.correspondence.cluster_sizes, back.correspondence.cluster_sizes);
}

TEST(MatchSkeletons, MapsBothHalvesOfACycleToItsBranch) {
    const auto cup = describe(test::cup());
    const Match match = match_skeletons(cup, cup);
    EXPECT_EQ(match.correspondence.branches.size(), cup.branches.size());
    for (const auto& pair : match.correspondence.branches) EXPECT_EQ(pair.a, pair.b);
}

TEST(MatchSkeletons, TellsAPointFromNothingAndNothingFromSomething) {
    const auto nothing = describe(skeleton::SkeletonGraph{});
    EXPECT_EQ(skeleton_distance(nothing, nothing), 0.0);
    EXPECT_GT(skeleton_distance(nothing, describe(test::point())), 0.5);
    EXPECT_GT(skeleton_distance(nothing, describe(test::human(0.5))), 0.5);
    EXPECT_GT(skeleton_distance(describe(test::point()), describe(test::human(0.5))), 0.3);
}

}  // namespace
}  // namespace ossuary::matching
