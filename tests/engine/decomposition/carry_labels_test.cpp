#include "engine/decomposition/carry_labels.h"

#include <gtest/gtest.h>

#include "engine/mesh/decimate.h"
#include "engine/mesh/measures.h"
#include "tests/support/shapes.h"

namespace ossuary::decomposition {
namespace {

Vec3 center_of(const mesh::TriangleMesh& mesh, std::size_t triangle) {
    const auto [a, b, c] = mesh.corners(triangle);
    return (a + b + c) / 3.0;
}

/// Quarters of a surface around the z axis.
Segmentation quarters(const mesh::TriangleMesh& mesh) {
    Segmentation parts{{}, 4};
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Vec3 center = center_of(mesh, t);
        parts.labels.push_back((center.x() < 0.0 ? 1U : 0U) + (center.y() < 0.0 ? 2U : 0U));
    }
    return parts;
}

std::vector<double> area_shares(const mesh::TriangleMesh& mesh, const Segmentation& parts) {
    std::vector<double> shares(parts.parts, 0.0);
    const double whole = mesh::measure(mesh).surface_area;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        shares[parts.labels[t]] += mesh::triangle_area(mesh, t) / whole;
    }
    return shares;
}

TEST(CarryLabels, KeepsEachPartInItsPlaceAndSize) {
    const mesh::TriangleMesh mesh = test::torus_mesh(2.0, 0.5, 128, 64);
    const mesh::TriangleMesh copy = mesh::decimate(mesh, {.max_triangles = 1000});
    ASSERT_LE(copy.triangles.size(), 1000U);
    const Segmentation parts = quarters(mesh);
    const auto carried = carry_labels(mesh, parts, copy);
    ASSERT_TRUE(carried.ok()) << carried.error().message;
    EXPECT_EQ(carried->parts, 4U);
    ASSERT_EQ(carried->labels.size(), copy.triangles.size());
    const Segmentation expected = quarters(copy);
    std::size_t agreeing = 0;
    for (std::size_t t = 0; t < copy.triangles.size(); ++t) {
        if (carried->labels[t] == expected.labels[t]) ++agreeing;
    }
    EXPECT_GT(agreeing, copy.triangles.size() * 98 / 100);
    const auto before = area_shares(mesh, parts), after = area_shares(copy, *carried);
    for (std::size_t p = 0; p < 4; ++p) EXPECT_NEAR(after[p], before[p], 0.02) << p;
}

TEST(CarryLabels, LeavesLabelsAsTheyAreWhereTheCopyIsTheMesh) {
    mesh::TriangleMesh mesh = test::torus_mesh(2.0, 0.5, 24, 12);
    // Both sides of the surface, each of a part of its own, and a triangle that is a line.
    const std::size_t one_side = mesh.triangles.size();
    for (std::size_t t = 0; t < one_side; ++t) {
        const auto [a, b, c] = mesh.triangles[t];
        mesh.triangles.push_back({a, b, c});
    }
    mesh.triangles.insert(mesh.triangles.begin(), {0, 1, 1});
    mesh.face_count = static_cast<std::uint32_t>(mesh.triangles.size());
    mesh.face_of_triangle.resize(mesh.triangles.size());
    Segmentation parts{std::vector<std::uint32_t>(mesh.triangles.size(), 0), 2};
    for (std::size_t t = 1 + one_side; t < parts.labels.size(); ++t) parts.labels[t] = 1;
    const mesh::TriangleMesh copy = mesh::decimate(mesh, {.max_triangles = 5000});
    ASSERT_EQ(copy.triangles.size(), 2 * one_side);
    const auto carried = carry_labels(mesh, parts, copy);
    ASSERT_TRUE(carried.ok());
    EXPECT_EQ(carried->labels,
              std::vector<std::uint32_t>(parts.labels.begin() + 1, parts.labels.end()));
}

TEST(CarryLabels, LosesNoPartHoweverSmall) {
    const mesh::TriangleMesh mesh = test::icosphere_mesh(Vec3::Zero(), 1.0, 5);
    const mesh::TriangleMesh copy = mesh::decimate(mesh, {.max_triangles = 200});
    // Fifty single triangles among twenty thousand.
    Segmentation parts{std::vector<std::uint32_t>(mesh.triangles.size(), 0), 51};
    for (std::uint32_t p = 1; p <= 50; ++p) parts.labels[p * 397] = p;
    const auto carried = carry_labels(mesh, parts, copy);
    ASSERT_TRUE(carried.ok());
    std::vector<std::size_t> place(51, 0), count(51, 0);
    for (std::size_t t = 0; t < carried->labels.size(); ++t) {
        place[carried->labels[t]] = t;
        ++count[carried->labels[t]];
    }
    EXPECT_GE(count[0], 150U);
    for (std::uint32_t p = 1; p <= 50; ++p) {
        ASSERT_EQ(count[p], 1U) << p;
        EXPECT_LT((center_of(copy, place[p]) - center_of(mesh, p * 397)).norm(), 0.4) << p;
    }
}

TEST(CarryLabels, RefusesACopyThatHasNoRoomForTheParts) {
    const mesh::TriangleMesh mesh = test::icosphere_mesh(Vec3::Zero(), 1.0, 3);
    const mesh::TriangleMesh copy = mesh::decimate(mesh, {.max_triangles = 20});
    Segmentation parts{std::vector<std::uint32_t>(mesh.triangles.size(), 0), 100};
    for (std::uint32_t t = 0; t < 100; ++t) parts.labels[t] = t;
    const auto carried = carry_labels(mesh, parts, copy);
    ASSERT_FALSE(carried.ok());
    EXPECT_EQ(carried.error().code, ErrorCode::kInvalidArgument);
}

}  // namespace
}  // namespace ossuary::decomposition
