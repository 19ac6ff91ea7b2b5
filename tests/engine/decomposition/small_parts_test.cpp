#include "engine/decomposition/small_parts.h"

#include <gtest/gtest.h>

#include <set>

namespace ossuary::decomposition {
namespace {

/// Two sheets of ten quads in a row, the second apart from the first; each triangle of area 1/2.
SurfaceGraph two_strips() {
    mesh::TriangleMesh mesh;
    for (const double y : {0.0, 5.0}) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (int x = 0; x <= 10; ++x) {
            mesh.vertices.emplace_back(x, y, 0.0);
            mesh.vertices.emplace_back(x, y + 1, 0.0);
        }
        for (std::uint32_t x = 0; x < 10; ++x) {
            const std::uint32_t a = first + 2 * x;
            mesh.triangles.push_back({a, a + 2, a + 3});
            mesh.triangles.push_back({a, a + 3, a + 1});
        }
    }
    return surface_graph(mesh);
}

TEST(SmallParts, JoinTheNeighbourOfTheLongestBorder) {
    const SurfaceGraph surface = two_strips();
    std::vector<std::uint32_t> parts(40, 0);
    for (std::size_t t = 8; t < 20; ++t) parts[t] = 1;
    parts[8] = 2;  // beside part 0 by an edge of length 1, beside part 1 by two longer ones
    join_small_parts(surface, parts, 0.05);
    EXPECT_EQ(parts[8], 1u);
    EXPECT_EQ(parts[0], 0u);
}

TEST(SmallParts, StayWhereNothingBordersOnThemOrTheyAreLargeEnough) {
    const SurfaceGraph surface = two_strips();
    std::vector<std::uint32_t> parts(40, 0);
    for (std::size_t t = 20; t < 40; ++t) parts[t] = 1;  // the second sheet
    auto joined = parts;
    join_small_parts(surface, joined, 0.6);
    EXPECT_EQ(joined, parts) << "loose pieces";
    parts[0] = parts[1] = 2;
    joined = parts;
    join_small_parts(surface, joined, 0.05);
    EXPECT_EQ(joined, parts) << "a twentieth of the area";
    join_small_parts(surface, joined, 0.051);
    EXPECT_EQ(joined[0], 0u);
}

TEST(SmallParts, GrowTogetherBeforeTheyAreJoinedToLargeOnes) {
    const SurfaceGraph surface = two_strips();
    std::vector<std::uint32_t> parts(40, 0);
    for (std::size_t t = 10; t < 14; ++t) parts[t] = static_cast<std::uint32_t>(t);
    join_small_parts(surface, parts, 0.03);
    const std::vector<std::uint32_t> middle(parts.begin() + 10, parts.begin() + 14);
    EXPECT_EQ(std::set<std::uint32_t>(middle.begin(), middle.end()).size(), 2u);
}

}  // namespace
}  // namespace ossuary::decomposition
