#include "engine/voxel/betti.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/shapes.h"

namespace ossuary::voxel {
namespace {

using test::random_volume;

/// Components by flooding voxel by voxel, `set` or not, nothing shared with the code under test.
int flooded_components(const BitVolume& volume, bool set, int max_offset_sum) {
    const Vec3i size = volume.size();
    std::vector<char> seen(volume.voxel_count(), 0);
    const auto index = [&](const Vec3i& v) {
        return static_cast<std::size_t>(v.x() + size.x() * (v.y() + size.y() * v.z()));
    };
    int components = 0;
    for (int start = 0; start < static_cast<int>(volume.voxel_count()); ++start) {
        const Vec3i first(start % size.x(), start / size.x() % size.y(),
                          start / size.x() / size.y());
        if (seen[index(first)] || volume.test(first) != set) continue;
        ++components;
        std::vector<Vec3i> stack = {first};
        seen[index(first)] = 1;
        while (!stack.empty()) {
            const Vec3i v = stack.back();
            stack.pop_back();
            for (int code = 0; code < 27; ++code) {
                const Vec3i d(code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1);
                const Vec3i w = v + d;
                if (d.cwiseAbs().sum() > max_offset_sum || !volume.contains(w)) continue;
                if (seen[index(w)] || volume.test(w) != set) continue;
                seen[index(w)] = 1;
                stack.push_back(w);
            }
        }
    }
    return components;
}

/// The volume with one empty layer around it, so that the outside is one component.
BitVolume padded(const BitVolume& volume) {
    BitVolume result(volume.size() + Vec3i::Constant(2));
    for_each_voxel(volume, [&](const Vec3i& v) { result.set(v + Vec3i::Ones()); });
    return result;
}

/// Cells of the union of closed cubes counted one by one.
std::int64_t counted_euler(const BitVolume& volume) {
    const Vec3i last = 2 * volume.size();
    std::int64_t euler = 0;
    for (int z = 0; z <= last.z(); ++z) {
        for (int y = 0; y <= last.y(); ++y) {
            for (int x = 0; x <= last.x(); ++x) {
                // Even coordinates are lattice planes: a cell touches the cubes on both sides.
                const Vec3i cell(x, y, z);
                bool present = false;
                for (int code = 0; code < 8; ++code) {
                    Vec3i cube;
                    for (int axis = 0; axis < 3; ++axis) {
                        const bool upper = (code >> axis) & 1;
                        cube[axis] =
                            cell[axis] % 2 == 0 ? cell[axis] / 2 - (upper ? 0 : 1) : cell[axis] / 2;
                    }
                    present = present || volume.test_or_false(cube);
                }
                const int dimension = x % 2 + y % 2 + z % 2;
                if (present) euler += dimension % 2 == 0 ? 1 : -1;
            }
        }
    }
    return euler;
}

TEST(BettiNumbers, AreThoseOfTheBuiltShapes) {
    for (const auto& shape : test::volume_shapes()) {
        EXPECT_EQ(betti_numbers(shape.volume), shape.betti) << shape.name;
    }
}

TEST(BettiNumbers, OfAnEmptyVolumeAreZero) {
    EXPECT_EQ(betti_numbers(BitVolume({5, 6, 7})), (BettiNumbers{0, 0, 0}));
    EXPECT_EQ(betti_numbers(BitVolume()), (BettiNumbers{0, 0, 0}));
}

TEST(BettiNumbers, CountDiagonalContactAsConnectedInTheForegroundOnly) {
    BitVolume corner_contact({4, 4, 4});
    corner_contact.set(1, 1, 1);
    corner_contact.set(2, 2, 2);
    EXPECT_EQ(betti_numbers(corner_contact), (BettiNumbers{1, 0, 0}));

    // The inner voxel of a 3x3x3 block is a cavity while the six face centres close it ...
    BitVolume block({5, 5, 5});
    for (int z = 1; z < 4; ++z) {
        for (int y = 1; y < 4; ++y) {
            for (int x = 1; x < 4; ++x) block.set(x, y, z);
        }
    }
    block.reset(2, 2, 2);
    EXPECT_EQ(betti_numbers(block), (BettiNumbers{1, 0, 1}));
    // ... even where only a corner is missing, since the background is 6-connected.
    block.reset(1, 1, 1);
    EXPECT_EQ(betti_numbers(block), (BettiNumbers{1, 0, 1}));
    block.reset(2, 2, 1);
    EXPECT_EQ(betti_numbers(block), (BettiNumbers{1, 0, 0}));
    block.reset(2, 2, 3);
    EXPECT_EQ(betti_numbers(block), (BettiNumbers{1, 1, 0}));
}

TEST(BettiNumbers, SeeVoxelsInTheOutermostLayerAndFullWords) {
    for (const int nx : {1, 63, 64, 65, 128}) {
        const BitVolume full = [&] {
            BitVolume v({nx, 3, 3});
            for (int z = 0; z < 3; ++z) {
                for (int y = 0; y < 3; ++y) {
                    for (int x = 0; x < nx; ++x) v.set(x, y, z);
                }
            }
            return v;
        }();
        EXPECT_EQ(betti_numbers(full), (BettiNumbers{1, 0, 0})) << nx;
        BitVolume drilled = full;
        for (int x = 0; x < nx; ++x) drilled.reset(x, 1, 1);
        EXPECT_EQ(betti_numbers(drilled), (BettiNumbers{1, 1, 0})) << nx;
    }
}

TEST(BettiNumbers, AgreeWithFloodingAndCountingOnRandomVolumes) {
    int checked = 0;
    for (std::uint64_t seed = 0; seed < 10'000; ++seed) {
        const Vec3i size(1 + static_cast<int>(seed % 9), 1 + static_cast<int>(seed / 9 % 6),
                         1 + static_cast<int>(seed / 54 % 7));
        const BitVolume volume =
            random_volume(size, 0.1 + 0.1 * static_cast<double>(seed % 8), seed);
        const BettiNumbers betti = betti_numbers(volume);
        const std::int64_t euler = counted_euler(volume);
        ASSERT_EQ(euler_characteristic(volume), euler) << seed;
        ASSERT_EQ(betti.components, flooded_components(volume, true, 3)) << seed;
        ASSERT_EQ(betti.cavities, flooded_components(padded(volume), false, 1) - 1) << seed;
        ASSERT_EQ(betti.tunnels, betti.components + betti.cavities - euler) << seed;
        ASSERT_GE(betti.tunnels, 0) << seed;
        ++checked;
    }
    EXPECT_EQ(checked, 10'000);
}

TEST(BettiNumbers, DoNotDependOnTheAxesOrder) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const BitVolume volume = random_volume({70, 9, 12}, 0.3, seed);
        const BettiNumbers betti = betti_numbers(volume);
        EXPECT_EQ(betti_numbers(test::permuted(volume, {2, 0, 1})), betti) << seed;
        EXPECT_EQ(betti_numbers(test::mirrored(volume, 0)), betti) << seed;
    }
}

}  // namespace
}  // namespace ossuary::voxel
