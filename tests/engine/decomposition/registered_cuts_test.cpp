#include "engine/decomposition/registered_cuts.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ossuary::decomposition {
namespace {

constexpr int kLength = 20;

/// A closed square tube of unit squares along x, without ends.
mesh::TriangleMesh tube() {
    mesh::TriangleMesh mesh;
    for (int x = 0; x <= kLength; ++x) {
        for (const auto& [y, z] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
            mesh.vertices.emplace_back(x, y, z);
        }
    }
    for (std::uint32_t x = 0; x < kLength; ++x) {
        for (std::uint32_t side = 0; side < 4; ++side) {
            const std::uint32_t a = 4 * x + side, b = 4 * x + (side + 1) % 4;
            mesh.triangles.push_back({a, b, b + 4});
            mesh.triangles.push_back({a, b + 4, a + 4});
        }
    }
    return mesh;
}

/// The cuts of the tube across at these places; each is 4 long.
std::vector<Cut> cuts_at(const std::vector<int>& places) {
    const mesh::TriangleMesh mesh = tube();
    std::vector<std::uint32_t> labels;
    for (int t = 0; t < 8 * kLength; ++t) {
        const int x = t / 8;
        labels.push_back(static_cast<std::uint32_t>(
            std::count_if(places.begin(), places.end(), [&](int place) { return place <= x; })));
    }
    return find_cuts(mesh, mesh::build_edge_table(mesh), dense_segmentation(labels));
}

TEST(RegisteredCuts, AreTheClosedLinesBetweenParts) {
    const std::vector<Cut> cuts = cuts_at({3, 9});
    ASSERT_EQ(cuts.size(), 2U);
    for (const Cut& cut : cuts) {
        EXPECT_EQ(cut.nodes.size(), 4U);
        EXPECT_DOUBLE_EQ(cut.length, 4.0);
    }
    EXPECT_DOUBLE_EQ(cuts[0].center.x(), 3.0);
    EXPECT_DOUBLE_EQ(cuts[1].center.x(), 9.0);
}

TEST(RegisteredCuts, CountApartWhereTwoPartsTouchTwice) {
    const mesh::TriangleMesh mesh = tube();
    std::vector<std::uint32_t> labels;
    for (int t = 0; t < 8 * kLength; ++t) labels.push_back(t / 8 >= 5 && t / 8 < 12 ? 1 : 0);
    EXPECT_EQ(find_cuts(mesh, mesh::build_edge_table(mesh), {labels, 2}).size(), 2U);
}

TEST(RegisteredCuts, OfEqualSegmentationsAreNoDistanceApart) {
    const RegisteredCuts found = register_cuts(cuts_at({4, 11}), cuts_at({4, 11}));
    EXPECT_EQ(found.pairs, 2U);
    EXPECT_EQ(found.total(), 0.0);
    EXPECT_EQ(found.missing, 0.0);
}

TEST(RegisteredCuts, AddTheDistancesOfTheNearest) {
    const RegisteredCuts found = register_cuts(cuts_at({4, 11}), cuts_at({5, 13}));
    EXPECT_EQ(found.pairs, 2U);
    EXPECT_DOUBLE_EQ(found.total(), 1.0 + 2.0);
}

TEST(RegisteredCuts, AddTheLengthOfThoseWithoutACounterpart) {
    const RegisteredCuts found = register_cuts(cuts_at({4}), cuts_at({4, 6, 15}));
    EXPECT_EQ(found.pairs, 1U);
    EXPECT_DOUBLE_EQ(found.additional, 2 * 4.0);
    EXPECT_DOUBLE_EQ(found.total(), 2 * 4.0);
    EXPECT_EQ(found.missing, 0.0);
    const RegisteredCuts fewer = register_cuts(cuts_at({4, 6, 15}), cuts_at({4}));
    EXPECT_EQ(fewer.total(), 0.0);
    EXPECT_DOUBLE_EQ(fewer.missing, 2 * 4.0);
}

TEST(RegisteredCuts, AreNotPairedAcrossTheModel) {
    const RegisteredCuts found = register_cuts(cuts_at({2}), cuts_at({18}));
    EXPECT_EQ(found.pairs, 0U);
    EXPECT_DOUBLE_EQ(found.total(), 4.0);
    EXPECT_DOUBLE_EQ(found.missing, 4.0);
}

}  // namespace
}  // namespace ossuary::decomposition
