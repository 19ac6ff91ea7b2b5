#include "engine/descriptor/summed_volume.h"

#include <gtest/gtest.h>

#include "tests/support/random.h"
#include "tests/support/shapes.h"

namespace ossuary::descriptor {
namespace {

TEST(SummedVolume, CountsWhatCountingOneByOneDoes) {
    const voxel::BitVolume volume = test::random_volume({70, 13, 9}, 0.4, 3);
    const SummedVolume sums(volume);
    std::mt19937_64 random(8);
    for (int round = 0; round < 200; ++round) {
        Vec3i low, high;
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = static_cast<int>(test::next_below(random, 90)) - 10;
            high[axis] = low[axis] + static_cast<int>(test::next_below(random, 60));
        }
        std::uint32_t expected = 0;
        voxel::for_each_voxel(volume, [&](const Vec3i& v) {
            expected += (v.array() >= low.array()).all() && (v.array() < high.array()).all();
        });
        ASSERT_EQ(sums.count(low, high), expected) << low.transpose() << " to " << high.transpose();
    }
}

}  // namespace
}  // namespace ossuary::descriptor
