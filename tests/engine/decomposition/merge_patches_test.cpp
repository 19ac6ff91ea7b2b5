#include "engine/decomposition/merge_patches.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/decomposition/pair_features.h"

namespace ossuary::decomposition {
namespace {

using ::testing::ElementsAre;

/// A chain of patches with so many triangles each.
PatchGraph chain(const std::vector<std::uint32_t>& triangles) {
    PatchGraph graph;
    graph.links.resize(triangles.size());
    for (std::uint32_t p = 0; p < triangles.size(); ++p) {
        graph.patches.push_back({Vec3(p, 0, 0), Vec3::UnitZ(), 1.0, triangles[p]});
        if (p == 0) continue;
        graph.links[p - 1].push_back({p, 1.0, 0.0});
        graph.links[p].push_back({p - 1, 1.0, 0.0});
    }
    return graph;
}

std::vector<float> table(const std::vector<std::vector<float>>& lower) {
    std::vector<float> together;
    for (const auto& row : lower) together.insert(together.end(), row.begin(), row.end());
    return together;
}

TEST(MergePatches, JoinsWhatProbablyBelongsTogether) {
    const auto together = table({{0.9F}, {0.1F, 0.1F}, {0.1F, 0.1F, 0.9F}});
    EXPECT_THAT(merge_patches(chain({1, 1, 1, 1}), together), ElementsAre(0, 0, 1, 1));
}

TEST(MergePatches, JoinsOnlyPartsThatTouch) {
    const auto together = table({{0.1F}, {0.9F, 0.1F}});
    EXPECT_THAT(merge_patches(chain({1, 1, 1}), together), ElementsAre(0, 1, 2));
}

TEST(MergePatches, WeighsEveryPairByItsTriangles) {
    // The third patch belongs to the second but not to the first, which is larger or smaller.
    const auto together = table({{0.9F}, {0.2F, 0.8F}});
    EXPECT_THAT(merge_patches(chain({10, 1, 1}), together), ElementsAre(0, 0, 1));
    EXPECT_THAT(merge_patches(chain({1, 10, 1}), together), ElementsAre(0, 0, 0));
}

TEST(MergePatches, StopsAtTheWantedNumber) {
    const auto together = table({{0.6F}, {0.6F, 0.7F}, {0.6F, 0.6F, 0.6F}});
    const PatchGraph graph = chain({1, 1, 1, 1});
    EXPECT_THAT(merge_patches(graph, together), ElementsAre(0, 0, 0, 0));
    EXPECT_THAT(merge_patches(graph, together, {.parts = 3}), ElementsAre(0, 1, 1, 2));
    EXPECT_THAT(merge_patches(graph, together, {.parts = 9}), ElementsAre(0, 1, 2, 3));
}

}  // namespace
}  // namespace ossuary::decomposition
