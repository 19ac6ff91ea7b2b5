#include "engine/voxel/distance_transform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "engine/voxel/distance_envelope.h"
#include "engine/voxel/distance_scan.h"
#include "tests/support/shapes.h"

namespace ossuary::voxel {
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

std::vector<std::uint32_t> scanned(const BitVolume& volume) {
    const auto field = distances_by_scan(volume);
    return field ? field->values() : std::vector<std::uint32_t>();
}

TEST(DistanceTransform, IsTheSameByScanAndByEnvelopes) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        const BitVolume volume =
            test::random_volume({40 + static_cast<int>(seed) * 3, 50, 60}, 0.9995, seed);
        EXPECT_EQ(scanned(volume), distances_by_envelope(volume).values()) << seed;
    }
    for (const auto& shape : test::volume_shapes()) {
        EXPECT_EQ(scanned(shape.volume), distances_by_envelope(shape.volume).values())
            << shape.name;
    }
}

TEST(DistanceTransform, ScansUpToTheFarthestThatFits) {
    constexpr int kSide = 2 * kFarthestScan;
    const BitVolume flat = test::random_volume({kSide, kSide, 60}, 1.1, 0);
    EXPECT_EQ(scanned(flat), distances_by_envelope(flat).values()) << "the largest values it meets";

    // A cube whose middle is farther from the border than the scan can tell.
    constexpr int kTooLong = kSide + 3;
    BitVolume cube(Vec3i::Constant(kTooLong));
    for (int z = 0; z < kTooLong; ++z) {
        for (int y = 0; y < kTooLong; ++y) {
            const auto row = cube.row(y, z);
            std::fill(row.begin(), row.end(), ~std::uint64_t{0});
            row.back() = (std::uint64_t{1} << kTooLong % 64) - 1;
        }
    }
    const DistanceField field = distance_transform(cube);
    EXPECT_EQ(field.distance(Vec3i::Constant(kTooLong / 2)), kFarthestScan + 2);
    EXPECT_EQ(field.distance({kTooLong / 2, 100, kTooLong / 2}), 101);
}

TEST(DistanceTransform, ScansLongSidesWhereTheSolidIsThin) {
    for (const Vec3i& size : {Vec3i(600, 20, 24), Vec3i(20, 600, 24), Vec3i(24, 20, 600),
                              Vec3i(420, 420, 30), Vec3i(30, 420, 420), Vec3i(420, 30, 420)}) {
        const BitVolume volume = test::random_volume(size, 0.9999, 1);
        EXPECT_EQ(scanned(volume), distances_by_envelope(volume).values()) << size.transpose();
    }
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
}  // namespace ossuary::voxel
