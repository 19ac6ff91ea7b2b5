#include "engine/voxel/border.h"

#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace ossuary::voxel {
namespace {

TEST(Border, HasExactlyTheVoxelsWithABackgroundFaceNeighbour) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        const BitVolume volume =
            test::random_volume({60 + static_cast<int>(seed), 7, 9}, 0.9, seed);
        std::vector<Vec3i> expected;
        for_each_voxel(volume, [&](const Vec3i& v) {
            for (const Vec3i& d : {Vec3i(1, 0, 0), Vec3i(-1, 0, 0), Vec3i(0, 1, 0), Vec3i(0, -1, 0),
                                   Vec3i(0, 0, 1), Vec3i(0, 0, -1)}) {
                if (!volume.test_or_false(v + d)) {
                    expected.push_back(v);
                    return;
                }
            }
        });
        ASSERT_EQ(border_points(volume), expected) << seed;
    }
}

}  // namespace
}  // namespace ossuary::voxel
