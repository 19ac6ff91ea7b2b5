#include "engine/voxel/distance_transform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "engine/voxel/distance_envelope.h"
#include "engine/voxel/distance_scan.h"
#include "tests/support/shapes.h"

namespace ossuary {
namespace {

/// The nearest background voxel by trying all, the layer around the volume included.
std::uint32_t nearest_background(const BitVolume& volume, const Vec3i& v) {
    std::int64_t best = std::numeric_limits<std::int64_t>::max();
    const Vec3i size = volume.size();
    for (int z = -1; z <= size.z(); ++z) {
        for (int y = -1; y <= size.y(); ++y) {
            for (int x = -1; x <= size.x(); ++x) {
                const Vec3i w(x, y, z);
                if (!volume.test_or_false(w)) {
                    best = std::min<std::int64_t>(best, (w - v).squaredNorm());
                }
            }
        }
    }
    return static_cast<std::uint32_t>(best);
}

TEST(DistanceTransform, EqualsTheNearestBackgroundVoxelOnRandomVolumes) {
    int voxels = 0;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        const Vec3i size(3 + static_cast<int>(seed % 17), 2 + static_cast<int>(seed % 13),
                         1 + static_cast<int>(seed % 11));
        const double density = seed % 3 == 0 ? 0.5 : (seed % 3 == 1 ? 0.97 : 0.995);
        const BitVolume volume = test::random_volume(size, density, seed);
        const DistanceField field = distance_transform(volume);
        for (int z = 0; z < size.z(); ++z) {
            for (int y = 0; y < size.y(); ++y) {
                for (int x = 0; x < size.x(); ++x, ++voxels) {
                    const Vec3i v(x, y, z);
                    ASSERT_EQ(field.squared(v), volume.test(v) ? nearest_background(volume, v) : 0u)
                        << "seed " << seed << " at " << v.transpose();
                }
            }
        }
    }
    EXPECT_GT(voxels, 10'000);
}

TEST(DistanceTransform, OfAFullVolumeIsTheDistanceToItsBorder) {
    const Vec3i size(70, 20, 33);
    const BitVolume volume = test::random_volume(size, 1.1, 0);
    ASSERT_EQ(volume.count(), volume.voxel_count());
    const DistanceField field = distance_transform(volume);
    for_each_voxel(volume, [&](const Vec3i& v) {
        const int d = std::min((v + Vec3i::Ones()).minCoeff(), (size - v).minCoeff());
        ASSERT_EQ(field.squared(v), static_cast<std::uint32_t>(d * d));
    });
}

TEST(DistanceTransform, IsTheSameByScanAndByEnvelopes) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        const BitVolume volume =
            test::random_volume({40 + static_cast<int>(seed) * 3, 50, 60}, 0.9995, seed);
        EXPECT_EQ(distances_by_scan(volume).values(), distances_by_envelope(volume).values())
            << seed;
    }
    for (const auto& shape : test::volume_shapes()) {
        EXPECT_EQ(distances_by_scan(shape.volume).values(),
                  distances_by_envelope(shape.volume).values())
            << shape.name;
    }
    // The largest values that the scan meets.
    const BitVolume full = test::random_volume({kMaxScanSide, kMaxScanSide, 60}, 1.1, 0);
    EXPECT_EQ(distances_by_scan(full).values(), distances_by_envelope(full).values());
}

TEST(DistanceTransform, TakesSidesBeyondTheScan) {
    const BitVolume volume = test::random_volume({20, kMaxScanSide + 40, 20}, 0.999, 1);
    EXPECT_EQ(distance_transform(volume).values(), distances_by_envelope(volume).values());
}

TEST(DistanceTransform, FollowsThePermutationOfTheAxes) {
    const BitVolume volume = test::capsule_tree().volume;
    const DistanceField field = distance_transform(volume);
    const Vec3i order(1, 2, 0);
    const DistanceField turned = distance_transform(test::permuted(volume, order));
    for_each_voxel(volume, [&](const Vec3i& v) {
        ASSERT_EQ(turned.squared({v[order[0]], v[order[1]], v[order[2]]}), field.squared(v));
    });
}

TEST(DistanceTransform, OfABallPeaksAtItsCentre) {
    const DistanceField field = distance_transform(test::ball(20).volume);
    const auto peak = std::max_element(field.values().begin(), field.values().end());
    EXPECT_NEAR(std::sqrt(static_cast<double>(*peak)), 20.0, 1.0);
}

TEST(DistanceTransform, OfNothingIsNothing) {
    EXPECT_TRUE(distance_transform(BitVolume()).values().empty());
    const DistanceField field = distance_transform(BitVolume({3, 4, 5}));
    for (int z = 0; z < 5; ++z) {
        for (int y = 0; y < 4; ++y) {
            for (int x = 0; x < 3; ++x) EXPECT_EQ(field.squared({x, y, z}), 0u);
        }
    }
}

}  // namespace
}  // namespace ossuary
