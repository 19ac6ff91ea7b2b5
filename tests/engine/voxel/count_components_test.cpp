#include "engine/voxel/count_components.h"

#include <gtest/gtest.h>

#include "engine/voxel/components.h"
#include "tests/support/shapes.h"

namespace ossuary::voxel {
namespace {

TEST(CountComponents, FindsAsManyAsLabelling) {
    std::size_t several = 0;
    for (std::uint64_t seed = 0; seed < 600; ++seed) {
        const Vec3i size(1 + static_cast<int>(seed % 137), 1 + static_cast<int>(seed % 11),
                         1 + static_cast<int>(seed % 7));
        const double density = 0.02 + 0.06 * static_cast<double>(seed % 5);
        const BitVolume volume = test::random_volume(size, density, seed);
        const std::size_t expected = label_components(volume, Connectivity::kVertices).count();
        EXPECT_EQ(count_components(volume), expected) << seed;
        several += expected > 1 ? 1 : 0;
    }
    EXPECT_GT(several, 300u);
    EXPECT_EQ(count_components(BitVolume({0, 0, 0})), 0u);
    EXPECT_EQ(count_components(BitVolume({70, 3, 3})), 0u);
}

}  // namespace
}  // namespace ossuary::voxel
