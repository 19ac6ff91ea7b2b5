#include "engine/ranking/fusion.h"

#include <gtest/gtest.h>

namespace ossuary::ranking {
namespace {

/// What a collection of many kinds says.
constexpr ModelScale kScale = {{0.5, 2900.0, 2100.0, 16800.0, 218000.0, 4330.0, 6140.0},
                               {0.07, 1050.0, 1000.0, 3430.0, 80000.0, 1490.0, 1500.0}};

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
        for (std::size_t c = 0; c < component_count(ranker); ++c) {
            ComponentValues distances{};
            distances[c] = 0.01 * kScale.mean[c];
            EXPECT_GT(fused_distance(distances, one, one), 0.0) << component_name(c);
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

TEST(Fusion, TakesNoNoticeOfTheLayoutWithoutPose) {
    constexpr std::size_t kLayout = 2;
    ASSERT_EQ(component_name(kLayout), "skeleton_layout");
    const ComponentValues near = shares_of_mean({0.5, 0.1, 0.05, 0.2, 0.4, 0.4, 0.4});
    ComponentValues far = near;
    far[kLayout] = kScale.mean[kLayout];
    for (const RankerKind ranker : {RankerKind::kSkeleton, RankerKind::kHybrid}) {
        const FusionSide build = side(ranker, 0.0), both = side(ranker);
        EXPECT_EQ(fused_distance(near, build, build), fused_distance(far, build, build));
        EXPECT_LT(fused_distance(near, both, both), fused_distance(far, both, both));
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
