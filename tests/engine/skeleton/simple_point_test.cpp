#include "engine/skeleton/simple_point.h"

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

#include "engine/core/parallel.h"
#include "engine/voxel/betti.h"

namespace ossuary::skeleton {
namespace {

constexpr Neighborhood kLowBits = kCentre - 1;

/// Spreads 26 bits over the neighbourhood, leaving out the centre.
constexpr Neighborhood with_gap(std::uint32_t bits) {
    return (bits & kLowBits) | (bits & ~kLowBits) << 1;
}

voxel::BitVolume volume_of(Neighborhood object) {
    voxel::BitVolume volume(Vec3i(5, 5, 5));
    for_each_bit(object, [&](int bit) {
        const NeighborOffset o = neighbor_offset(bit);
        volume.set(2 + o.dx, 2 + o.dy, 2 + o.dz);
    });
    return volume;
}

TEST(SimplePoint, AgreesWithTheDefinitionOnAllNeighborhoods) {
    const SimplePointTest& is_simple = SimplePointTest::shared();
    constexpr std::size_t kChunks = 256;
    constexpr std::uint32_t kChunk = (1u << 26) / kChunks;
    std::atomic<std::uint64_t> wrong = 0;
    std::atomic<std::uint64_t> simple = 0;
    parallel_for(kChunks, 0, [&](std::size_t chunk) {
        std::uint64_t wrong_here = 0;
        std::uint64_t simple_here = 0;
        for (std::uint32_t i = 0; i < kChunk; ++i) {
            const Neighborhood object = with_gap(static_cast<std::uint32_t>(chunk) * kChunk + i);
            const bool expected = is_simple_by_definition(object);
            simple_here += expected;
            wrong_here += is_simple(object) != expected;
        }
        wrong += wrong_here;
        simple += simple_here;
    });
    EXPECT_EQ(wrong, 0u);
    // As counted by Couprie & Bertrand, "New characterizations of simple points in 2D, 3D, and 4D
    // discrete spaces", 2009.
    EXPECT_EQ(simple, 25'985'144u);
}

TEST(SimplePoint, DoesNotLookAtTheCentre) {
    const SimplePointTest& is_simple = SimplePointTest::shared();
    for (std::uint32_t bits = 0; bits < 1u << 26; bits += 9973) {
        const Neighborhood object = with_gap(bits);
        EXPECT_EQ(is_simple(object), is_simple(object | kCentre));
    }
}

TEST(SimplePoint, MeansThatTheBettiNumbersStayWhenTheCentreGoes) {
    const SimplePointTest& is_simple = SimplePointTest::shared();
    int simple = 0;
    for (std::uint32_t bits = 1; bits < 1u << 26; bits += 65'521) {
        const Neighborhood object = with_gap(bits);
        const bool same = voxel::betti_numbers(volume_of(object)) ==
                          voxel::betti_numbers(volume_of(object | kCentre));
        EXPECT_EQ(is_simple(object), same) << std::hex << object;
        simple += is_simple(object);
    }
    EXPECT_GT(simple, 100);
}

TEST(SimplePoint, KnowsThePlainCases) {
    const SimplePointTest& is_simple = SimplePointTest::shared();
    EXPECT_FALSE(is_simple(0)) << "an isolated voxel";
    EXPECT_FALSE(is_simple(k26Neighbors)) << "an inner voxel";
    EXPECT_TRUE(is_simple(Neighborhood{1})) << "the end of a line";
    EXPECT_FALSE(is_simple(Neighborhood{1} | Neighborhood{1} << 26)) << "the middle of a line";
    EXPECT_FALSE(is_simple(k26Neighbors & ~(Neighborhood{1} << 4 | Neighborhood{1} << 22)))
        << "the wall between two hollows";
    EXPECT_TRUE(is_simple(k26Neighbors & ~(Neighborhood{1} << 4))) << "the rim of a pit";
}

TEST(Neighborhood, DilationsReachExactlyTheAdjacentVoxels) {
    for (int a = 0; a < 27; ++a) {
        const NeighborOffset p = neighbor_offset(a);
        for (int b = 0; b < 27; ++b) {
            const NeighborOffset q = neighbor_offset(b);
            const int dx = std::abs(p.dx - q.dx);
            const int dy = std::abs(p.dy - q.dy);
            const int dz = std::abs(p.dz - q.dz);
            const bool adjacent_26 = dx <= 1 && dy <= 1 && dz <= 1;
            const bool adjacent_6 = dx + dy + dz <= 1;
            EXPECT_EQ(dilate_26(Neighborhood{1} << a) >> b & 1u, adjacent_26 ? 1u : 0u);
            EXPECT_EQ(dilate_6(Neighborhood{1} << a) >> b & 1u, adjacent_6 ? 1u : 0u);
        }
    }
}

}  // namespace
}  // namespace ossuary::skeleton
