#include "engine/matching/match_part.h"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/engine/matching/built_skeletons.h"

namespace ossuary::matching {
namespace {

using test::describe;

double part_distance(const SkeletonDescriptor& part, const SkeletonDescriptor& whole) {
    PartEdit edit;
    return part_distance(PartQuery(part), whole, edit);
}

/// Shoulder, elbow and hand with three fingers.
void add_arm(test::SkeletonBuilder& body, std::uint32_t shoulder, const Vec3& at, double side) {
    const auto elbow = body.node(at + Vec3(side * 30, 0, -10), 5);
    const auto hand = body.node(at + Vec3(side * 55, 10, -10), 4);
    body.branch(shoulder, elbow, Vec3(0, 3, 0));
    body.branch(elbow, hand);
    for (const double y : {0.0, 10.0, 22.0}) {
        body.branch(hand, body.node(at + Vec3(side * 75, y, -10), 2));
    }
}

skeleton::SkeletonGraph arm() {
    test::SkeletonBuilder body;
    add_arm(body, body.node(Vec3::Zero(), 7), Vec3::Zero(), 1.0);
    return body.graph();
}

skeleton::SkeletonGraph body_with_arms() {
    test::SkeletonBuilder body;
    const auto chest = body.node(Vec3(0, 0, 0), 7);
    const auto hips = body.node(Vec3(0, 0, -60), 12);
    body.branch(chest, hips);
    body.branch(chest, body.node(Vec3(0, 0, 30), 9));
    body.branch(hips, body.node(Vec3(-20, 0, -150), 6));
    body.branch(hips, body.node(Vec3(20, 0, -150), 6));
    add_arm(body, chest, Vec3::Zero(), 1.0);
    add_arm(body, chest, Vec3::Zero(), -1.0);
    return body.graph();
}

TEST(MatchPart, FindsASkeletonInItself) {
    std::mt19937 random(31);
    for (const skeleton::SkeletonGraph& graph :
         {test::human(0.3), test::four_leg(0.6), test::curve(), arm(),
          test::random_skeleton(random, 14, 0)}) {
        EXPECT_NEAR(part_distance(describe(graph), describe(graph)), 0.0, 1e-5);
    }
}

TEST(MatchPart, FindsACutOffArmOfUnknownSizeInItsBody) {
    const SkeletonDescriptor whole = describe(body_with_arms(), 100.0);
    for (const double scale : {100.0, 60.0, 45.0, 33.0}) {
        // Between two candidate sizes it fits a little less well than at one.
        EXPECT_LT(part_distance(describe(arm(), scale), whole), 0.3) << scale;
    }
    for (const skeleton::SkeletonGraph& other :
         {test::octopus(0.4), test::four_leg(0.4), test::curve()}) {
        EXPECT_GT(part_distance(describe(arm(), 60.0), describe(other)),
                  part_distance(describe(arm(), 60.0), whole));
    }
}

TEST(MatchPart, NamesTheArmThatItFound) {
    const SkeletonDescriptor part = describe(arm(), 64.0);
    const SkeletonDescriptor whole = describe(body_with_arms(), 100.0);
    const Match match = match_part(PartQuery(part), whole);
    // Shoulder, elbow, hand and three fingers.
    EXPECT_EQ(match.correspondence.nodes.size(), 6U);
    ASSERT_EQ(match.correspondence.cluster_sizes.size(), 1U);
    EXPECT_EQ(match.correspondence.cluster_sizes[0], 6U);
    EXPECT_EQ(match.correspondence.branches.size(), part.branches.size());
    for (const auto& pair : match.correspondence.branches) {
        EXPECT_NEAR(whole.branches[pair.b].length, 0.64 * part.branches[pair.a].length, 0.03);
    }
}

TEST(MatchPart, IsNoMatterOfPlaceTurningMirroringOrNumbering) {
    std::mt19937 random(32);
    const Mat3 turn = Eigen::AngleAxisd(0.9, Vec3(1, -2, 1).normalized()).toRotationMatrix();
    const Mat3 mirror = Vec3(1, -1, 1).asDiagonal();
    const SkeletonDescriptor part = describe(arm(), 64.0);
    const skeleton::SkeletonGraph whole = body_with_arms();
    const double expected = part_distance(part, describe(whole));
    for (const Mat3& linear : {turn, mirror}) {
        const skeleton::SkeletonGraph changed =
            test::moved(test::renumbered(whole, random), linear, Vec3(5, 6, 7), 2.0);
        EXPECT_NEAR(part_distance(part, describe(changed, 200.0)), expected, 1e-3);
        const skeleton::SkeletonGraph other_part =
            test::moved(test::renumbered(arm(), random), linear, Vec3(5, 6, 7), 3.0);
        EXPECT_NEAR(part_distance(describe(other_part, 192.0), describe(whole)), expected, 1e-3);
    }
}

TEST(MatchPart, LetsAWholeHaveAnythingBesides) {
    std::mt19937 random(33);
    for (int round = 0; round < 10; ++round) {
        const SkeletonDescriptor part = describe(test::random_skeleton(random, 6, 0));
        test::SkeletonBuilder both;
        const SkeletonDescriptor other = describe(test::random_skeleton(random, 12, 0));
        // Two components: what is in the second cannot make the first less of a place.
        SkeletonDescriptor whole = part;
        const auto shift = static_cast<std::uint32_t>(whole.nodes.size());
        whole.nodes.insert(whole.nodes.end(), other.nodes.begin(), other.nodes.end());
        for (SkeletonDescriptor::Branch branch : other.branches) {
            branch.a += shift;
            branch.b += shift;
            whole.branches.push_back(std::move(branch));
        }
        derive_matching_data(whole);
        EXPECT_NEAR(part_distance(part, whole), 0.0, 1e-5);
    }
}

TEST(MatchPart, ChargesASideLimbLittleAndMissingLimbsInFull) {
    const auto rod = [](bool with_side, double side_length) {
        test::SkeletonBuilder body;
        const auto start = body.node(Vec3(0, 0, 0), 5);
        const auto middle = body.node(Vec3(50, 0, 0), 5);
        const auto end = body.node(Vec3(100, 0, 0), 5);
        body.branch(start, middle);
        body.branch(middle, end);
        if (with_side) body.branch(middle, body.node(Vec3(50, side_length, 0), 5));
        return describe(body.graph(), 100.0);
    };
    const SkeletonDescriptor plain = rod(false, 0.0);
    EXPECT_NEAR(part_distance(plain, rod(true, 60.0)), part_distance(plain, rod(true, 300.0)),
                0.03);
    EXPECT_LT(part_distance(plain, rod(true, 300.0)), 0.2);
    EXPECT_GT(part_distance(rod(true, 60.0), plain), 0.2);
}

TEST(MatchPart, StaysBetweenZeroAndOneWithPartsThatAddUp) {
    std::mt19937 random(34);
    std::vector<SkeletonDescriptor> all = {describe(test::human(0.2)),
                                           describe(test::cup()),
                                           describe(test::ring()),
                                           describe(test::point()),
                                           describe(skeleton::SkeletonGraph{}),
                                           describe(test::figure_eight()),
                                           describe(test::two_components())};
    for (int round = 0; round < 8; ++round) {
        all.push_back(describe(test::random_skeleton(random, 2 + 2 * round, round % 3)));
    }
    PartEdit edit;
    for (const SkeletonDescriptor& part : all) {
        const PartQuery query(part);
        for (const SkeletonDescriptor& whole : all) {
            const Match match = match_part(query, whole);
            EXPECT_EQ(match.distance, part_distance(query, whole, edit));
            EXPECT_GE(match.distance, 0.0);
            EXPECT_LE(match.distance, 1.0);
            double sum = 0.0;
            for (const DistancePart& share : match.parts) {
                EXPECT_GE(share.value, 0.0);
                sum += share.value;
            }
            EXPECT_NEAR(sum, match.distance, 1e-4);
            for (const auto& pair : match.correspondence.nodes) {
                ASSERT_LT(pair.a, part.nodes.size());
                ASSERT_LT(pair.b, whole.nodes.size());
            }
            for (const auto& pair : match.correspondence.branches) {
                ASSERT_LT(pair.a, part.branches.size());
                ASSERT_LT(pair.b, whole.branches.size());
            }
            const auto& sizes = match.correspondence.cluster_sizes;
            EXPECT_EQ(std::accumulate(sizes.begin(), sizes.end(), std::size_t{0}),
                      match.correspondence.nodes.size());
        }
    }
}

TEST(MatchPart, FindsNothingEverywhereAndSomethingNowhereInNothing) {
    EXPECT_EQ(part_distance(describe(skeleton::SkeletonGraph{}), describe(test::human(0.5))), 0.0);
    EXPECT_EQ(part_distance(describe(test::human(0.5)), describe(skeleton::SkeletonGraph{})), 1.0);
    EXPECT_NEAR(part_distance(describe(test::human(0.5)), describe(test::point())), 1.0, 1e-5);
}

}  // namespace
}  // namespace ossuary::matching
