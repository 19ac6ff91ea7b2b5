#include "engine/ranking/fusion.h"

#include <gtest/gtest.h>

namespace ossuary::ranking {
namespace {

/// What a collection of many kinds says.
constexpr ModelScale kScale = {
    {0.5, 2900.0, 2100.0, 16800.0, 218000.0, 4330.0, 6140.0, 3.0, 0.4, 1.0},
    {0.07, 1050.0, 1000.0, 3430.0, 80000.0, 1490.0, 1500.0, 1.0, 0.1, 1.0}};

/// A body of three limbs from one node.
descriptor::ModelDescriptor a_model() {
    descriptor::ModelDescriptor model;
    model.skeleton.nodes.resize(4);
    for (std::uint32_t tip = 1; tip < 4; ++tip) {
        model.skeleton.branches.push_back({0, tip, "", {}, {}, 0.6F});
    }
    model.skeleton.solid_volume = 0.034F;
    model.skeleton.limb_volume = 0.034F;
    return model;
}

FusionSide side(RankerKind ranker, double pose = RankOptions{}.pose) {
    return fusion_side(a_model(), kScale, {.ranker = ranker, .pose = pose});
}

/// Distances as shares of their means.
ComponentValues shares_of_mean(const ComponentValues& shares) {
    ComponentValues distances{};
    for (std::size_t c = 0; c < kComponentCount; ++c) distances[c] = shares[c] * kScale.mean[c];
    return distances;
}

TEST(Fusion, IsZeroForEqualModelsAlone) {
    for (const RankerKind ranker : {RankerKind::kSkeleton, RankerKind::kHybrid}) {
        const FusionSide one = side(ranker);
        EXPECT_EQ(fused_distance({}, one, one), 0.0);
        const FusionSide build = side(ranker, 0.0), pose = side(ranker, 1.0);
        for (std::size_t c = 0; c < kComponentCount; ++c) {
            if (!fuses(ranker, c) || c == kSizeComponent) continue;
            ComponentValues distances{};
            distances[c] = 0.01 * kScale.mean[c];
            EXPECT_EQ(fused_distance(distances, one, one) > 0.0, c < kBuildComponent)
                << component_name(c);
            EXPECT_EQ(fused_distance(distances, build, build) > 0.0, c == kBuildComponent)
                << component_name(c);
            EXPECT_EQ(fused_distance(distances, pose, pose) > 0.0, c == kPoseComponent)
                << component_name(c);
        }
    }
}

TEST(Fusion, PutsACopyWithAnotherTreeBeforeALikeModelWithTheSameTree) {
    const ComponentValues copy = shares_of_mean({0.8, 0.07, 0.05, 0.2, 0.2, 0.2, 0.2});
    const ComponentValues like = shares_of_mean({0.05, 0.3, 0.3, 0.4, 0.2, 0.2, 0.2});
    for (const RankerKind ranker : {RankerKind::kSkeleton, RankerKind::kHybrid}) {
        const FusionSide one = side(ranker);
        EXPECT_LT(fused_distance(copy, one, one), fused_distance(like, one, one));
    }
}

TEST(Fusion, KeepsTheTreesWordWhereNothingIsNear) {
    const ComponentValues same_tree = shares_of_mean({0.3, 0.7, 0.7, 0.7, 0.7, 0.7, 0.7});
    const ComponentValues other_tree = shares_of_mean({0.8, 0.6, 0.6, 0.7, 0.7, 0.7, 0.7});
    const FusionSide one = side(RankerKind::kSkeleton);
    EXPECT_LT(fused_distance(same_tree, one, one), fused_distance(other_tree, one, one));
}

TEST(Fusion, NeverFallsWhereADistanceGrows) {
    for (const RankerKind ranker : {RankerKind::kSkeleton, RankerKind::kHybrid}) {
        const FusionSide one = side(ranker);
        for (std::size_t c = 0; c < kComponentCount; ++c) {
            ComponentValues shares{0.5, 0.1, 0.1, 0.2, 0.4, 0.4, 0.4};
            double before = -1.0;
            for (shares[c] = 0.0; shares[c] < 3.0; shares[c] += 0.05) {
                const double now = fused_distance(shares_of_mean(shares), one, one);
                EXPECT_GE(now, before) << component_name(c) << " at " << shares[c];
                before = now;
            }
        }
    }
}

TEST(Fusion, GoesFromBuildAloneOverKindsToPoseAlone) {
    // One pair differs by build alone, one by pose alone: the more pose counts, the further away is
    // the latter and the nearer the former.
    ComponentValues other_build = shares_of_mean({0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.9, 0.2});
    ComponentValues other_pose = shares_of_mean({0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.2, 0.9});
    for (const RankerKind ranker : {RankerKind::kSkeleton, RankerKind::kHybrid}) {
        double before = -1.0;
        for (const double pose : {0.0, 0.05, 0.1, 0.15, 0.3, 0.5, 0.75, 1.0}) {
            const FusionSide one = side(ranker, pose);
            const double ratio =
                fused_distance(other_pose, one, one) / fused_distance(other_build, one, one);
            EXPECT_GE(ratio, before) << "at " << pose;
            before = ratio;
        }
        const FusionSide build = side(ranker, 0.0), pose = side(ranker, 1.0);
        ComponentValues changed = other_build;
        for (std::size_t c = 0; c < kBuildComponent; ++c) changed[c] *= 1.7;
        EXPECT_EQ(fused_distance(changed, pose, pose), fused_distance(other_build, pose, pose));
        changed[kPoseComponent] *= 1.7;
        EXPECT_EQ(fused_distance(changed, build, build), fused_distance(other_build, build, build));
    }
}

TEST(Fusion, TakesNoticeOfSizeWhereItCounts) {
    const ComponentValues like = shares_of_mean({0.5, 0.1, 0.1, 0.2, 0.4, 0.4, 0.4, 0.4, 0.4});
    ComponentValues larger = like, only_larger{};
    larger[kSizeComponent] = 0.1;
    only_larger[kSizeComponent] = 0.1;
    for (const double pose : {0.0, 0.15, 1.0}) {
        const auto side_of = [&](double size) {
            return fusion_side(a_model(), kScale, {.pose = pose, .size = size});
        };
        const FusionSide without = side_of(0.0), half = side_of(0.5), with = side_of(1.0);
        EXPECT_EQ(fused_distance(larger, without, without), fused_distance(like, without, without));
        EXPECT_EQ(fused_distance(only_larger, without, without), 0.0);
        EXPECT_GT(fused_distance(only_larger, half, half), 0.0);
        EXPECT_EQ(fused_distance(like, with, with), fused_distance(like, without, without));
        EXPECT_GT(fused_distance(larger, half, half), fused_distance(like, half, half));
        EXPECT_GT(fused_distance(larger, with, with), fused_distance(larger, half, half));
        double sum = 0.0;
        for (const double part : fused_parts(larger, with, with)) sum += part;
        EXPECT_NEAR(sum, fused_distance(larger, with, with), 1e-9);
        larger[kSizeComponent] = 1e9;
        EXPECT_LT(fused_distance(larger, with, with), 1e30);
        larger[kSizeComponent] = 0.1;
    }
}

TEST(Fusion, IsSymmetricAndSplitsIntoParts) {
    FusionSide one = side(RankerKind::kHybrid), other = one;
    other.scale.mean[1] *= 1.3;
    other.scale.deviation[3] *= 0.8;
    other.weights[0] *= 0.5;
    const ComponentValues distances = shares_of_mean({0.4, 0.1, 0.2, 0.3, 0.1, 0.5, 0.2});
    const double distance = fused_distance(distances, one, other);
    EXPECT_EQ(distance, fused_distance(distances, other, one));
    double sum = 0.0;
    for (const double part : fused_parts(distances, one, other)) sum += part;
    EXPECT_NEAR(sum, distance, 1e-12);
}

}  // namespace
}  // namespace ossuary::ranking
