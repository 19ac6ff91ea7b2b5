#include "engine/voxel/components.h"

#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace ossuary::voxel {
namespace {

TEST(Components, SeparateByFacesWhatTouchesByCorners) {
    BitVolume volume({70, 3, 3});
    volume.set(0, 0, 0);
    volume.set(1, 1, 1);
    volume.set(63, 2, 2);
    volume.set(64, 2, 2);
    EXPECT_EQ(label_components(volume, Connectivity::kVertices).voxel_counts,
              (std::vector<std::size_t>{2, 2}));
    EXPECT_EQ(label_components(volume, Connectivity::kFaces).voxel_counts,
              (std::vector<std::size_t>{1, 1, 2}));
}

TEST(Components, GiveNeighboursOneLabelAndCoverTheVolume) {
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        const BitVolume volume = test::random_volume({67, 8, 9}, 0.08, seed);
        const Components components = label_components(volume, Connectivity::kVertices);
        BitVolume rebuilt(volume.size());
        std::vector<int> label(volume.voxel_count(), -1);
        const auto at = [&](const Vec3i& v) -> int& {
            return label[static_cast<std::size_t>(v.x() + 67 * (v.y() + 8 * v.z()))];
        };
        std::size_t voxels = 0;
        for (const VoxelRun& run : components.runs) {
            set_run(rebuilt, run);
            for (int x = run.begin; x < run.end; ++x) {
                at({x, run.y, run.z}) = static_cast<int>(run.component);
            }
        }
        for (const std::size_t count : components.voxel_counts) voxels += count;
        EXPECT_EQ(rebuilt, volume);
        EXPECT_EQ(voxels, volume.count());
        for_each_voxel(volume, [&](const Vec3i& v) {
            for (int code = 0; code < 27; ++code) {
                const Vec3i w = v + Vec3i(code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1);
                ASSERT_TRUE(!volume.test_or_false(w) || at(v) == at(w));
            }
        });
        for (const VoxelRun& run : components.runs) reset_run(rebuilt, run);
        EXPECT_EQ(rebuilt.count(), 0u);
    }
}

TEST(FillCavities, FillsTheHollowBallAndNothingElse) {
    auto hollow = test::hollow_ball(12, 6);
    const BitVolume solid = test::ball(12).volume;
    const std::size_t missing = solid.count() - hollow.volume.count();
    const FilledCavities filled = fill_cavities(hollow.volume);
    EXPECT_EQ(filled.cavities, 1u);
    EXPECT_EQ(filled.voxels, missing);
    EXPECT_EQ(hollow.volume, solid);

    auto torus = test::torus();
    const BitVolume before = torus.volume;
    EXPECT_EQ(fill_cavities(torus.volume).cavities, 0u);
    EXPECT_EQ(torus.volume, before);
}

}  // namespace
}  // namespace ossuary::voxel
