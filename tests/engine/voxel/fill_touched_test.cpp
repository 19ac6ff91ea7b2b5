#include "engine/voxel/fill_touched.h"

#include <gtest/gtest.h>

#include "engine/voxel/close_gaps.h"
#include "engine/voxel/voxelize.h"
#include "tests/support/shapes.h"
#include "tests/support/worst_cases.h"

namespace ossuary::voxel {
namespace {

constexpr std::uint64_t kPlenty = std::uint64_t{1} << 40;

BitVolume touched(const mesh::TriangleMesh& mesh, int resolution) {
    VoxelizeOptions options;
    options.resolution = resolution;
    const auto grid = lay_into_grid(mesh, options);
    BitVolume volume(grid->size);
    const TouchedSurface result = fill_touched(*grid, kPlenty, {}, volume);
    EXPECT_EQ(result.triangles, grid->triangles.size() + grid->collapsed.size());
    return volume;
}

bool warns(const VoxelSolid& solid, std::string_view code) {
    for (const mesh::MeshWarning& warning : solid.warnings) {
        if (warning.code == code) return true;
    }
    return false;
}

TEST(FillTouched, HoldsASurfaceWithoutAHole) {
    for (const test::MeshShape& shape : test::mesh_shapes()) {
        BitVolume volume = touched(shape.mesh, 48);
        // Nothing of the exact solid is left out once what the surface encloses is filled.
        fill_cavities(volume);
        VoxelizeOptions options;
        options.resolution = 48;
        const auto exact = voxelize(shape.mesh, options);
        ASSERT_TRUE(exact);
        std::size_t missing = 0;
        for_each_voxel(exact->volume, [&](const Vec3i& v) { missing += volume.test(v) ? 0 : 1; });
        EXPECT_EQ(missing, 0u) << shape.name;
    }
}

TEST(FillTouched, DoesNotDependOnTheOrderOfTriangles) {
    const mesh::TriangleMesh mesh = test::worst_case("triangles_500k").build(300);
    const BitVolume expected = touched(mesh, 32);
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        EXPECT_EQ(touched(test::renumbered(mesh, seed), 32), expected);
    }
}

TEST(FillTouched, TakesTheSameSampleForEveryOrder) {
    const mesh::TriangleMesh mesh = test::worst_case("triangles_500k").build(300);
    const auto sample = [](const mesh::TriangleMesh& soup) {
        VoxelizeOptions options;
        options.resolution = 32;
        const auto grid = lay_into_grid(soup, options);
        BitVolume volume(grid->size);
        EXPECT_LT(fill_touched(*grid, 70'000, {}, volume).triangles, soup.triangles.size());
        return volume;
    };
    EXPECT_EQ(sample(test::renumbered(mesh, 1)), sample(mesh));
}

TEST(FillTouched, EndsWhereTheWorkIsTooMuch) {
    const mesh::TriangleMesh mesh = test::worst_case("slivers_500k").build(20'000);
    VoxelizeOptions options;
    const auto grid = lay_into_grid(mesh, options);
    BitVolume volume(grid->size);
    const TouchedSurface result = fill_touched(*grid, 100'000, {}, volume);
    EXPECT_LT(result.triangles, grid->triangles.size());
    EXPECT_GT(result.triangles, 100u);
    EXPECT_LT(result.work, 300'000u);
}

/// A soup of which lines tell nothing is a block, in bounded time and memory.
TEST(Voxelize, TakesTheSurfaceItselfForTheSolidWhereItIsEverywhere) {
    const mesh::TriangleMesh mesh = test::worst_case("triangles_500k").build(60'000);
    VoxelizeOptions options;
    options.resolution = 64;
    const auto solid = voxelize(mesh, options);
    ASSERT_TRUE(solid) << solid.error().message;
    EXPECT_EQ(solid->method, "touched");
    EXPECT_TRUE(warns(*solid, "dense_surface"));
    // All but the corners of the cube.
    EXPECT_GT(solid->volume.count(), 64u * 64u * 64u * 9u / 10u);
}

TEST(Voxelize, CostsOrdinaryMeshesLittle) {
    for (const test::MeshShape& shape : test::mesh_shapes()) {
        const auto solid = voxelize(shape.mesh);
        ASSERT_TRUE(solid);
        EXPECT_LT(solid->work, 1'000'000u) << shape.name;
        EXPECT_FALSE(warns(*solid, "dense_surface"));
        EXPECT_FALSE(warns(*solid, "closed_gaps"));
    }
}

TEST(CloseGaps, LeavesAPlainSolidAlone) {
    BitVolume torus = test::torus().volume;
    const BitVolume before = torus;
    EXPECT_EQ(close_gaps(torus, 2, {}), 0);
    EXPECT_EQ(torus, before);
}

TEST(CloseGaps, ClosesNarrowOnesFirst) {
    // A block with one wide tunnel and many of a voxel.
    BitVolume block({40, 40, 20});
    for (int z = 4; z < 16; ++z) {
        for (int y = 4; y < 36; ++y) {
            for (int x = 4; x < 36; ++x) {
                const bool wide = x >= 12 && x < 24 && y >= 12 && y < 24;
                if (!wide && (x % 4 != 1 || y % 4 != 1)) block.set(x, y, z);
            }
        }
    }
    ASSERT_GT(intricacy(betti_numbers(block)), 20u);
    BitVolume closed = block;
    EXPECT_EQ(close_gaps(closed, 5, {}), 2);
    const BettiNumbers shape = betti_numbers(closed);
    EXPECT_EQ(shape.components, 1);
    EXPECT_EQ(shape.tunnels, 1);
    EXPECT_FALSE(closed.test(18, 18, 10));
    for_each_voxel(block, [&](const Vec3i& v) { ASSERT_TRUE(closed.test(v)); });
}

TEST(CloseGaps, AlwaysComesToAnEnd) {
    BitVolume noise = test::random_volume({40, 40, 40}, 0.3, 1);
    for (int i = 0; i < 40; ++i) {
        for (int k = 0; k < 40; ++k) {
            for (const int margin : {0, 1, 38, 39}) {
                noise.reset(margin, i, k);
                noise.reset(i, margin, k);
                noise.reset(i, k, margin);
            }
        }
    }
    EXPECT_GT(close_gaps(noise, 1, {}), 0);
    EXPECT_EQ(intricacy(betti_numbers(noise)), 1u);
    for (int i = 0; i < 40; ++i) {
        for (int k = 0; k < 40; ++k) ASSERT_FALSE(noise.test(1, i, k) || noise.test(i, 38, k));
    }
}

TEST(Voxelize, ClosesTheGapsOfASponge) {
    const mesh::TriangleMesh mesh = test::worst_case("menger_sponge").build(3);
    VoxelizeOptions options;
    options.resolution = 81;
    options.close_small_tunnels = false;
    options.max_intricacy = 300;
    const auto solid = voxelize(mesh, options);
    ASSERT_TRUE(solid);
    EXPECT_TRUE(warns(*solid, "closed_gaps"));
    const BettiNumbers shape = betti_numbers(solid->volume);
    EXPECT_LE(intricacy(shape), 300u);
    EXPECT_GE(shape.tunnels, 5);
}

}  // namespace
}  // namespace ossuary::voxel
