#include "engine/decomposition/cut_discrepancy.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ossuary::decomposition {
namespace {

/// A strip of `length` unit squares along x, two triangles each.
mesh::TriangleMesh strip(int length) {
    mesh::TriangleMesh mesh;
    for (int x = 0; x <= length; ++x) {
        mesh.vertices.emplace_back(x, 0.0, 0.0);
        mesh.vertices.emplace_back(x, 1.0, 0.0);
    }
    for (std::uint32_t x = 0; x < static_cast<std::uint32_t>(length); ++x) {
        mesh.triangles.push_back({2 * x, 2 * x + 2, 2 * x + 3});
        mesh.triangles.push_back({2 * x, 2 * x + 3, 2 * x + 1});
    }
    return mesh;
}

/// The strip cut across at `x`.
Segmentation cut_at(int length, int x) {
    std::vector<std::uint32_t> labels;
    for (int t = 0; t < 2 * length; ++t) labels.push_back(t / 2 < x ? 0 : 1);
    return dense_segmentation(labels);
}

TEST(CutDiscrepancy, IsTheDistanceOfTwoParallelCuts) {
    const mesh::TriangleMesh mesh = strip(10);
    const CutDiscrepancy discrepancy(mesh);
    const auto a = discrepancy.cuts_of(cut_at(10, 3)), b = discrepancy.cuts_of(cut_at(10, 7));
    double radius = 0.0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto [p, q, r] = mesh.corners(t);
        radius += ((p + q + r) / 3.0 - Vec3(5.0, 0.5, 0.0)).norm() / 20.0;
    }
    EXPECT_EQ(a.vertices.size(), 2u);
    ASSERT_TRUE(discrepancy(a, b).has_value());
    EXPECT_NEAR(*discrepancy(a, b), 4.0 / radius, 1e-12);
    EXPECT_EQ(discrepancy(a, a), 0.0);
}

TEST(CutDiscrepancy, IsUndefinedWhereOnlyOneIsCut) {
    const CutDiscrepancy discrepancy(strip(4));
    const auto cut = discrepancy.cuts_of(cut_at(4, 2)), whole = discrepancy.cuts_of(cut_at(4, 0));
    EXPECT_FALSE(discrepancy(cut, whole).has_value());
    EXPECT_EQ(discrepancy(whole, whole), 0.0);
}

TEST(CutDiscrepancy, CountsEveryCutVertexOnce) {
    const CutDiscrepancy discrepancy(strip(10));
    // One cut against two: 2 vertices at distance 0, and of the other's 4, 2 at distance 0, 2 at 5.
    const auto one = discrepancy.cuts_of(cut_at(10, 2));
    std::vector<std::uint32_t> labels;
    for (int t = 0; t < 20; ++t) labels.push_back(t / 2 < 2 ? 0 : (t / 2 < 7 ? 1 : 2));
    const auto two = discrepancy.cuts_of(dense_segmentation(labels));
    const auto far = discrepancy.cuts_of(cut_at(10, 7));
    EXPECT_NEAR(*discrepancy(one, two) / *discrepancy(one, far), (2 * 5.0 / 6.0) / 5.0, 1e-12);
}

}  // namespace
}  // namespace ossuary::decomposition
