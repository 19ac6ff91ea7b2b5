#include "engine/descriptor/skeleton_pairs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/core/geometry.h"

namespace ossuary::descriptor {
namespace {

/// A rod of length 2 that is bent by `angle` in its middle.
matching::SkeletonDescriptor bent_rod(double angle, float radius = 0.05F) {
    skeleton::SkeletonGraph graph;
    const Vec3 tip = Vec3(std::cos(angle), std::sin(angle), 0.0);
    for (const Vec3& end : {Vec3(-1, 0, 0), Vec3(0, 0, 0), tip}) {
        graph.nodes.push_back({end, static_cast<double>(radius), 0.0, 1});
    }
    for (std::uint32_t i = 0; i < 2; ++i) {
        skeleton::SkeletonGraph::Branch branch{i, i + 1, {}, {}};
        for (int step = 0; step <= 20; ++step) {
            const double t = step / 20.0;
            branch.points.push_back((1.0 - t) * graph.nodes[i].position +
                                    t * graph.nodes[i + 1].position);
            branch.radii.push_back(static_cast<double>(radius));
        }
        graph.branches.push_back(branch);
    }
    return matching::describe_skeleton(graph, 1.0);
}

std::vector<std::uint8_t> pairs_of(const matching::SkeletonDescriptor& skeleton) {
    return skeleton_pairs({&skeleton, 1});
}

TEST(SkeletonPairs, BendingChangesThePoseAndNotTheBuild) {
    const auto straight = pairs_of(bent_rod(0.0));
    const auto bent = pairs_of(bent_rod(1.2));
    const auto thick = pairs_of(bent_rod(0.0, 0.15F));
    EXPECT_GT(skeleton_pairs_distance(straight, bent, 1.0), 50.0);
    EXPECT_LT(skeleton_pairs_distance(straight, bent, 0.0),
              0.1 * skeleton_pairs_distance(straight, bent, 1.0));
    EXPECT_GT(skeleton_pairs_distance(straight, thick, 0.0), 50.0);
}

TEST(SkeletonPairs, AreAMetricOnWhatTheyKeep) {
    const auto a = pairs_of(bent_rod(0.0));
    const auto b = pairs_of(bent_rod(0.7));
    for (const double pose : {0.0, 0.4, 1.0}) {
        EXPECT_EQ(skeleton_pairs_distance(a, a, pose), 0.0);
        EXPECT_EQ(skeleton_pairs_distance(a, b, pose), skeleton_pairs_distance(b, a, pose));
    }
}

TEST(SkeletonPairs, DoNotKnowWhereABranchBegins) {
    matching::SkeletonDescriptor turned = bent_rod(0.9);
    auto& branch = turned.branches.front();
    std::swap(branch.a, branch.b);
    std::reverse(branch.radii.begin(), branch.radii.end());
    for (std::size_t i = 0, j = branch.radii.size() - 1; i < j; ++i, --j) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            std::swap(branch.points[3 * i + axis], branch.points[3 * j + axis]);
        }
    }
    EXPECT_LE(skeleton_pairs_distance(pairs_of(turned), pairs_of(bent_rod(0.9))), 2.0);
}

TEST(SkeletonPairs, OfSeveralSkeletonsLieBetweenThoseOfEach) {
    const std::vector<matching::SkeletonDescriptor> both = {bent_rod(0.0), bent_rod(1.2)};
    const auto mean = skeleton_pairs(both);
    const auto a = pairs_of(both[0]), b = pairs_of(both[1]);
    const double apart = skeleton_pairs_distance(a, b);
    EXPECT_LT(skeleton_pairs_distance(mean, a), apart);
    EXPECT_LT(skeleton_pairs_distance(mean, b), apart);
}

TEST(SkeletonPairs, CopeWithAPointAndWithNothing) {
    matching::SkeletonDescriptor nothing;
    const auto of_nothing = pairs_of(nothing);
    EXPECT_EQ(of_nothing, std::vector<std::uint8_t>(kSkeletonPairsSize, 0));
    matching::SkeletonDescriptor point;
    point.nodes.push_back({{}, 0.2F, 0.0F});
    EXPECT_NE(pairs_of(point), of_nothing);
}

}  // namespace
}  // namespace ossuary::descriptor
