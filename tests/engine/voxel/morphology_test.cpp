#include "engine/voxel/morphology.h"

#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace ossuary::voxel {
namespace {

/// Whether the 2x2x2 block from v on is set.
bool is_block(const BitVolume& volume, const Vec3i& v) {
    for (int i = 0; i < 8; ++i) {
        if (!volume.test(v + Vec3i(i & 1, (i >> 1) & 1, i >> 2))) return false;
    }
    return true;
}

TEST(Morphology, NearAThickPartIsWithinAStepOfABlock) {
    std::size_t near = 0, far = 0;
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        const BitVolume volume = test::random_volume({131, 12, 11}, 0.45, seed);
        for (int z = 2; z < 9; ++z) {
            for (int y = 2; y < 10; ++y) {
                for (int x = 2; x < 129; ++x) {
                    bool expected = false;
                    for (int i = 0; i < 64; ++i) {
                        const Vec3i block(x - 2 + (i & 3), y - 2 + ((i >> 2) & 3),
                                          z - 2 + (i >> 4));
                        expected = expected || is_block(volume, block);
                    }
                    ASSERT_EQ(is_near_thick_part(volume, {x, y, z}), expected);
                    ++(expected ? near : far);
                }
            }
        }
    }
    EXPECT_GT(near, 1000u);
    EXPECT_GT(far, 1000u);
}

}  // namespace
}  // namespace ossuary::voxel
