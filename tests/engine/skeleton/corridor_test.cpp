#include "engine/skeleton/corridor.h"

#include <gtest/gtest.h>

#include "engine/skeleton/component_centres.h"
#include "engine/skeleton/thinning.h"
#include "engine/voxel/betti.h"
#include "engine/voxel/components.h"
#include "tests/support/shapes.h"

namespace ossuary::skeleton {
namespace {

void fill(voxel::BitVolume& volume, const Vec3i& begin, const Vec3i& end) {
    for (int z = begin.z(); z < end.z(); ++z) {
        for (int y = begin.y(); y < end.y(); ++y) {
            for (int x = begin.x(); x < end.x(); ++x) volume.set(x, y, z);
        }
    }
}

/// Two bars of 5x5x300 voxels, `gap` apart, joined at their upper ends.
voxel::BitVolume hairpin(int gap) {
    voxel::BitVolume volume(Vec3i(14 + gap, 9, 304));
    fill(volume, {2, 2, 2}, {7, 7, 302});
    fill(volume, {7 + gap, 2, 2}, {12 + gap, 7, 302});
    fill(volume, {7, 2, 297}, {7 + gap, 7, 302});
    return volume;
}

PathsInBlocks coarse_paths(const voxel::BitVolume& solid, const voxel::DistanceField& distance,
                           int edge, std::vector<VoxelIndex>& centres) {
    BlockGrid blocks(solid, distance, edge);
    const PaddedShape shape(solid.size());
    std::vector<VoxelIndex> centre_blocks;
    for (const ComponentCentre& centre : component_centres(solid, distance)) {
        centres.push_back(centre.voxel);
        centre_blocks.push_back(blocks.block_of(shape.position(centre.voxel)));
    }
    Tips tips = find_tips(blocks, centre_blocks, 2.5, {});
    return {std::move(blocks), std::move(tips)};
}

TEST(FinerPaths, HaveEachTipInItsBlockAndOneTree) {
    const voxel::BitVolume solid = test::capsule_tree(2.0).volume;
    const voxel::DistanceField distance = voxel::distance_transform(solid);
    for (const int edge : {4, 8}) {
        std::vector<VoxelIndex> centres;
        const PathsInBlocks coarse = coarse_paths(solid, distance, edge, centres);
        const PathsInBlocks finer = finer_paths(coarse, solid, distance, centres);
        EXPECT_EQ(finer.blocks.edge(), edge / 2);
        ASSERT_EQ(finer.tips.blocks.size(), coarse.tips.blocks.size());
        ASSERT_GE(finer.tips.blocks.size(), 6u);
        for (std::size_t i = 0; i < finer.tips.blocks.size(); ++i) {
            const Vec3i part = finer.blocks.shape().position(finer.tips.blocks[i]);
            EXPECT_EQ(coarse.blocks.shape().index(part / 2), coarse.tips.blocks[i]);
        }
        EXPECT_EQ(voxel::betti_numbers(finer.tips.tree.volume()).components, 1);
    }
}

TEST(FinerPaths, OfSomeBlocksAreThoseOfAll) {
    const voxel::BitVolume solid = test::random_volume({40, 37, 43}, 0.6, 3);
    const voxel::DistanceField distance = voxel::distance_transform(solid);
    for (const int edge : {1, 2, 4, 8}) {
        const BlockGrid all(solid, distance, edge);
        const BlockGrid again(solid, distance, edge, all.occupied());
        all.occupied().for_each([&](VoxelIndex b) {
            ASSERT_TRUE(again.occupied().test(b));
            ASSERT_EQ(again.links(b), all.links(b)) << edge;
            ASSERT_EQ(again.squared_radius(b), all.squared_radius(b)) << edge;
        });
    }
}

TEST(FinerPaths, GoRoundWhereBlocksJoinWhatTheSolidDoesNot) {
    for (const int gap : {1, 2, 3}) {
        const voxel::BitVolume solid = hairpin(gap);
        const voxel::BitVolume skeleton = thin(solid, voxel::distance_transform(solid));
        EXPECT_EQ(voxel::betti_numbers(skeleton), (voxel::BettiNumbers{1, 0, 0}));
        EXPECT_GE(skeleton.count(), 2u * 290u) << "both legs, gap " << gap;
        for (const int x : {2, 7 + gap}) {
            int rows = 0;
            for (int z = 10; z < 290; ++z) {
                bool any = false;
                for (int i = 0; i < 25; ++i) any |= skeleton.test(x + i % 5, 2 + i / 5, z);
                rows += any ? 1 : 0;
            }
            EXPECT_EQ(rows, 280) << "leg at " << x << ", gap " << gap;
        }
    }
}

TEST(Corridor, HoldsTheTreesBlocksAndJoinsTheirVoxels) {
    const voxel::BitVolume solid = test::capsule_tree().volume;
    const voxel::DistanceField distance = voxel::distance_transform(solid);
    std::vector<VoxelIndex> centres;
    const PathsInBlocks paths = coarse_paths(solid, distance, 2, centres);
    const ThinningGrid corridor = corridor_along(paths, solid, distance);
    paths.tips.tree.for_each([&](VoxelIndex block) {
        paths.blocks.for_each_voxel_of(solid, block, [&](const Vec3i& v) {
            EXPECT_TRUE(corridor.test(corridor.shape().index(v)));
        });
    });
    const voxel::BitVolume voxels = corridor.volume();
    voxel::for_each_voxel(voxels, [&](const Vec3i& v) { EXPECT_TRUE(solid.test(v)); });
    EXPECT_EQ(voxel::label_components(voxels, voxel::Connectivity::kVertices).count(), 1u);
    EXPECT_LT(voxels.count() * 4, solid.count());
}

}  // namespace
}  // namespace ossuary::skeleton
