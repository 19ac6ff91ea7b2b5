#include "engine/skeleton/thinning.h"

#include <gtest/gtest.h>

#include <random>

#include "engine/skeleton/simple_point.h"
#include "engine/skeleton/thinning_grid.h"
#include "engine/voxel/betti.h"
#include "tests/support/shapes.h"

namespace ossuary::skeleton {
namespace {

constexpr std::array kMethods = {ThinningMethod::kAnchored, ThinningMethod::kParallel};

voxel::BitVolume thinned(const voxel::BitVolume& solid, ThinningMethod method) {
    ThinningOptions options;
    options.method = method;
    return thin(solid, voxel::distance_transform(solid), options);
}

bool is_subset(const voxel::BitVolume& a, const voxel::BitVolume& b) {
    for (std::size_t w = 0; w < a.words().size(); ++w) {
        if ((a.words()[w] & ~b.words()[w]) != 0) return false;
    }
    return a.size() == b.size();
}

/// Voxels that could go without changing the topology and are not ends.
int removable_voxels(const voxel::BitVolume& skeleton) {
    const ThinningGrid grid(skeleton);
    int removable = 0;
    grid.for_each([&](VoxelIndex v) {
        const Neighborhood around = grid.neighborhood(v);
        removable += std::popcount(around & k26Neighbors) >= 2 && SimplePointTest::shared()(around);
    });
    return removable;
}

struct Valences {
    int ends = 0;
    int middles = 0;
    int junctions = 0;
};
Valences valences(const voxel::BitVolume& skeleton) {
    const ThinningGrid grid(skeleton);
    Valences result;
    grid.for_each([&](VoxelIndex v) {
        const int count = std::popcount(grid.neighborhood(v) & k26Neighbors);
        (count <= 1 ? result.ends : count == 2 ? result.middles : result.junctions)++;
    });
    return result;
}

TEST(Thinning, KeepsTheTopologyOfEveryBuiltShape) {
    for (const test::VolumeShape& shape : test::volume_shapes()) {
        for (const ThinningMethod method : kMethods) {
            SCOPED_TRACE(shape.name + " " + std::string(to_string(method)));
            const voxel::BitVolume skeleton = thinned(shape.volume, method);
            EXPECT_EQ(voxel::betti_numbers(skeleton), shape.betti);
            EXPECT_TRUE(is_subset(skeleton, shape.volume));
            EXPECT_EQ(removable_voxels(skeleton), 0);
        }
    }
}

TEST(Thinning, KeepsTheTopologyOfRandomVolumes) {
    int tunnels = 0;
    int cavities = 0;
    for (int round = 0; round < 10000; ++round) {
        std::mt19937 random(static_cast<unsigned>(round));
        Vec3i size(4 + static_cast<int>(random() % 15), 4 + static_cast<int>(random() % 15),
                   4 + static_cast<int>(random() % 15));
        // Long enough that tips are searched in blocks of 2, 4 and 8 voxels.
        if (round % 50 == 0) size[round / 50 % 3] = 65 + static_cast<int>(random() % 500);
        constexpr std::array kDensities = {0.05, 0.2, 0.35, 0.5, 0.65, 0.8, 0.9, 0.97};
        const double density = kDensities[static_cast<std::size_t>(round) % kDensities.size()];
        const voxel::BitVolume solid =
            test::random_volume(size, density, static_cast<std::uint64_t>(round));
        const voxel::BettiNumbers expected = voxel::betti_numbers(solid);
        tunnels += expected.tunnels;
        cavities += expected.cavities;
        for (const ThinningMethod method : kMethods) {
            SCOPED_TRACE(std::to_string(round) + " " + std::string(to_string(method)));
            const voxel::BitVolume skeleton = thinned(solid, method);
            ASSERT_EQ(voxel::betti_numbers(skeleton), expected);
            ASSERT_TRUE(is_subset(skeleton, solid));
            ASSERT_EQ(removable_voxels(skeleton), 0);
        }
    }
    EXPECT_GT(tunnels, 1000);
    EXPECT_GT(cavities, 1000);
}

TEST(Thinning, MakesALineOfABarWithItsWholeLength) {
    for (const Vec3i& size : {Vec3i(4, 4, 100), Vec3i(5, 5, 100), Vec3i(2, 2, 60)}) {
        for (const ThinningMethod method : kMethods) {
            SCOPED_TRACE(std::to_string(size.x()) + " " + std::string(to_string(method)));
            const voxel::BitVolume skeleton = thinned(test::bar(size).volume, method);
            const Valences v = valences(skeleton);
            EXPECT_EQ(v.ends, 2);
            EXPECT_EQ(v.junctions, 0);
            EXPECT_GE(v.middles, size.z() - 2 - 2 * size.x());
        }
    }
}

TEST(Thinning, MakesACircleOfATorus) {
    const Valences v = valences(thinned(test::torus().volume, ThinningMethod::kParallel));
    EXPECT_EQ(v.ends, 0);
    EXPECT_EQ(v.junctions, 0);
    EXPECT_GT(v.middles, 100);
}

TEST(Thinning, FindsTheTipsOfATree) {
    const voxel::BitVolume skeleton =
        thinned(test::capsule_tree().volume, ThinningMethod::kAnchored);
    EXPECT_EQ(valences(skeleton).ends, 6);
}

TEST(Thinning, StaysInTheMiddleOfABar) {
    const test::VolumeShape bar = test::bar({9, 9, 80});
    const voxel::DistanceField distance = voxel::distance_transform(bar.volume);
    for (const ThinningMethod method : kMethods) {
        SCOPED_TRACE(to_string(method));
        const voxel::BitVolume skeleton = thinned(bar.volume, method);
        voxel::for_each_voxel(skeleton, [&](const Vec3i& v) {
            const int from_end = std::min(v.z() - 2, 81 - v.z());
            if (from_end <= 8) return;
            EXPECT_EQ(distance.squared(v), 25u) << v.transpose();
        });
    }
}

TEST(Thinning, CopesWithDegenerateVolumes) {
    for (const ThinningMethod method : kMethods) {
        SCOPED_TRACE(to_string(method));
        EXPECT_EQ(thinned(voxel::BitVolume(), method).count(), 0u);
        EXPECT_EQ(thinned(voxel::BitVolume(Vec3i(3, 4, 5)), method).count(), 0u);

        voxel::BitVolume full(Vec3i(7, 6, 5));
        voxel::for_each_voxel(test::random_volume(full.size(), 1.0, 1),
                              [&](const Vec3i& v) { full.set(v); });
        EXPECT_EQ(voxel::betti_numbers(thinned(full, method)), (voxel::BettiNumbers{1, 0, 0}));

        voxel::BitVolume single(Vec3i(1, 1, 1));
        single.set(0, 0, 0);
        EXPECT_EQ(thinned(single, method), single);

        voxel::BitVolume block(Vec3i(2, 2, 2));
        for (int i = 0; i < 8; ++i) block.set(i & 1, i >> 1 & 1, i >> 2);
        const voxel::BitVolume thin_block = thinned(block, method);
        EXPECT_EQ(voxel::betti_numbers(thin_block), (voxel::BettiNumbers{1, 0, 0}));
        EXPECT_LE(thin_block.count(), 2u);

        voxel::BitVolume diagonal(Vec3i(65, 65, 65));
        for (int i = 0; i < 65; ++i) diagonal.set(i, i, i);
        EXPECT_EQ(thinned(diagonal, method), diagonal) << "a thin line is its own skeleton";
    }
}

TEST(Thinning, TreatsEachComponentOnItsOwn) {
    voxel::BitVolume two(Vec3i(40, 12, 60));
    for (int z = 2; z < 52; ++z) {
        for (int y = 2; y < 7; ++y) {
            for (int x = 2; x < 7; ++x) {
                two.set(x, y, z);
                two.set(x + 20, y, z);
            }
        }
    }
    for (const ThinningMethod method : kMethods) {
        SCOPED_TRACE(to_string(method));
        const voxel::BitVolume skeleton = thinned(two, method);
        EXPECT_EQ(voxel::betti_numbers(skeleton).components, 2);
        EXPECT_EQ(valences(skeleton).ends, 4);
    }
}

TEST(Thinning, DoesNotDependOnTheOrderOfTheAxesInTipsAndJunctions) {
    const voxel::BitVolume solid = test::capsule_tree().volume;
    const Valences expected = valences(thinned(solid, ThinningMethod::kAnchored));
    for (const Vec3i& order : {Vec3i(1, 2, 0), Vec3i(2, 1, 0), Vec3i(0, 2, 1)}) {
        const voxel::BitVolume skeleton =
            thinned(test::permuted(solid, order), ThinningMethod::kAnchored);
        EXPECT_EQ(valences(skeleton).ends, expected.ends);
    }
    for (int axis = 0; axis < 3; ++axis) {
        const voxel::BitVolume skeleton =
            thinned(test::mirrored(solid, axis), ThinningMethod::kAnchored);
        EXPECT_EQ(valences(skeleton).ends, expected.ends);
    }
}

TEST(Thinning, GivesTheSameVoxelsEachTime) {
    const voxel::BitVolume solid = test::double_torus().volume;
    for (const ThinningMethod method : kMethods) {
        EXPECT_EQ(thinned(solid, method), thinned(solid, method));
    }
}

TEST(Thinning, NamesItsMethods) {
    for (const ThinningMethod method : kMethods) {
        const auto parsed = parse_thinning_method(to_string(method));
        ASSERT_TRUE(parsed.ok());
        EXPECT_EQ(*parsed, method);
    }
    const auto unknown = parse_thinning_method("directional");
    ASSERT_FALSE(unknown.ok());
    EXPECT_EQ(unknown.error().code, ErrorCode::kInvalidArgument);
}

}  // namespace
}  // namespace ossuary::skeleton
