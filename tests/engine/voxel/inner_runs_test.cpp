#include "engine/voxel/inner_runs.h"

#include <gtest/gtest.h>

#include "engine/voxel/components.h"
#include "tests/support/shapes.h"

namespace ossuary::voxel {
namespace {

TEST(InnerRuns, CountAsManyCavitiesAsLabellingTheBackground) {
    std::size_t cavities = 0;
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        const Vec3i size(1 + static_cast<int>(seed % 70), 1 + static_cast<int>(seed % 11),
                         1 + static_cast<int>(seed % 7));
        const BitVolume volume =
            test::random_volume(size, 0.3 + 0.2 * static_cast<double>(seed % 4), seed);
        const std::size_t expected = label_background(volume).count() - 1;
        EXPECT_EQ(count_cavities(volume), expected) << seed;
        cavities += expected;
    }
    EXPECT_GT(cavities, 1000u);
}

}  // namespace
}  // namespace ossuary::voxel
