#include "engine/mesh/triangulate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <set>

#include "tests/engine/mesh/built_meshes.h"

namespace ossuary::test {
namespace {

struct Cut {
    double area = 0.0;  ///< sum of the triangles' areas
    Vec3 signed_area = Vec3::Zero();
    std::size_t triangles = 0;
    std::size_t fanned = 0;
};

Vec3 polygon_area(const std::vector<Vec3>& outline) {
    Vec3 area = Vec3::Zero();
    for (std::size_t i = 0; i < outline.size(); ++i) {
        area += 0.5 * outline[i].cross(outline[(i + 1) % outline.size()]);
    }
    return area;
}

Cut cut(const std::vector<Vec3>& outline) {
    std::vector<std::uint32_t> polygon(outline.size());
    std::iota(polygon.begin(), polygon.end(), 0u);
    std::vector<mesh::TriangleMesh::Triangle> triangles;
    mesh::PolygonTriangulator triangulator;
    triangulator.append(polygon, outline, triangles);
    Cut result;
    result.triangles = triangles.size();
    result.fanned = triangulator.fanned();
    for (const auto& [a, b, c] : triangles) {
        const Vec3 area = 0.5 * (outline[b] - outline[a]).cross(outline[c] - outline[a]);
        result.area += area.norm();
        result.signed_area += area;
    }
    return result;
}

/// A polygon that can be seen whole from the origin; mostly concave.
std::vector<Vec3> random_star(std::size_t corners, std::mt19937_64& random) {
    std::vector<Vec3> outline;
    for (std::size_t i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(i) / double(corners);
        const double radius = uniform(random, 0.2, 1.0);
        outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    }
    return outline;
}

TEST(Triangulate, CoversSimplePolygonsExactlyWhateverTheirPlane) {
    std::mt19937_64 random(3);
    for (int round = 0; round < 300; ++round) {
        const std::size_t corners = 4 + random() % 40;
        std::vector<Vec3> outline = random_star(corners, random);
        const Mat3 rotation =
            Eigen::AngleAxisd(
                uniform(random, 0, 6),
                Vec3(uniform(random, -1, 1), uniform(random, -1, 1), 0.1).normalized())
                .toRotationMatrix();
        for (Vec3& corner : outline) corner = rotation * corner + Vec3(3, -1, 2);
        const Vec3 area = polygon_area(outline);
        const Cut result = cut(outline);
        EXPECT_EQ(result.triangles, corners - 2);
        EXPECT_EQ(result.fanned, 0u);
        // The areas add up without sign only if no triangle lies outside or upside down.
        EXPECT_NEAR(result.area, area.norm(), 1e-9);
        EXPECT_NEAR((result.signed_area - area).norm(), 0.0, 1e-9);
    }
}

TEST(Triangulate, KeepsTheOrientationOfReversedPolygons) {
    std::mt19937_64 random(4);
    std::vector<Vec3> outline = random_star(15, random);
    const Vec3 forward = cut(outline).signed_area;
    std::reverse(outline.begin(), outline.end());
    EXPECT_NEAR((cut(outline).signed_area + forward).norm(), 0.0, 1e-12);
}

TEST(Triangulate, CutsConvexPolygonsTheSameWayWhereverTheyBeginAndWhicheverWayTheyGo) {
    std::vector<Vec3> outline;
    for (int i = 0; i < 7; ++i) {
        outline.emplace_back(std::cos(2 * std::numbers::pi * i / 7),
                             std::sin(2 * std::numbers::pi * i / 7), 0.0);
    }
    std::vector<std::uint32_t> polygon = {3, 6, 0, 5, 1, 4, 2};  // names of the corners in turn
    std::vector<Vec3> vertices(7);
    for (std::size_t i = 0; i < 7; ++i) vertices[polygon[i]] = outline[i];
    const auto triangles_of = [&](const std::vector<std::uint32_t>& corners) {
        std::vector<mesh::TriangleMesh::Triangle> triangles;
        mesh::PolygonTriangulator().append(corners, vertices, triangles);
        return triangles;
    };
    const auto expected = triangles_of(polygon);
    std::vector<mesh::TriangleMesh::Triangle> turned_over = expected;
    for (auto& triangle : turned_over) std::swap(triangle[1], triangle[2]);
    for (int begin = 0; begin < 7; ++begin) {
        std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
        EXPECT_EQ(triangles_of(polygon), expected);
        EXPECT_EQ(triangles_of({polygon.rbegin(), polygon.rend()}), turned_over);
    }
}

TEST(Triangulate, GivesNoTriangleWithoutAreaToAPolygonWithStraightCorners) {
    std::vector<Vec3> outline;
    for (int i = 0; i < 5; ++i) outline.emplace_back(i, 0, 0);
    for (int i = 0; i < 5; ++i) outline.emplace_back(5, i, 0);
    for (int i = 5; i > 0; --i) outline.emplace_back(i, 5, 0);
    for (int i = 5; i > 0; --i) outline.emplace_back(0, i, 0);
    std::vector<std::uint32_t> polygon(outline.size());
    std::iota(polygon.begin(), polygon.end(), 0u);
    std::vector<mesh::TriangleMesh::Triangle> triangles;
    mesh::PolygonTriangulator().append(polygon, outline, triangles);
    for (const auto& [a, b, c] : triangles) {
        EXPECT_GT((outline[b] - outline[a]).cross(outline[c] - outline[a]).z(), 1e-9);
    }
    EXPECT_EQ(triangles.size(), outline.size() - 2);
}

TEST(Triangulate, GivesEveryPolygonItsTrianglesHoweverFolded) {
    std::mt19937_64 random(5);
    for (int round = 0; round < 500; ++round) {
        const std::size_t corners = 4 + random() % 12;
        std::vector<Vec3> outline;
        for (std::size_t i = 0; i < corners; ++i) {
            outline.emplace_back(double(random() % 3), double(random() % 3), double(random() % 3));
        }
        EXPECT_EQ(cut(outline).triangles, corners - 2);
    }
}

TEST(Triangulate, CutsAPentagramByItsCornersOnly) {
    std::vector<Vec3> outline;
    for (int i = 0; i < 5; ++i) {
        const double angle = 4 * std::numbers::pi * i / 5;
        outline.emplace_back(std::cos(angle), std::sin(angle), 0);
    }
    EXPECT_EQ(cut(outline).triangles, 3u);
}

TEST(Triangulate, FallsBackToFansWhenItsWorkIsSpent) {
    std::mt19937_64 random(6);
    const std::vector<Vec3> outline = random_star(200, random);
    std::vector<std::uint32_t> polygon(outline.size());
    std::iota(polygon.begin(), polygon.end(), 0u);
    std::vector<mesh::TriangleMesh::Triangle> triangles;
    mesh::PolygonTriangulator triangulator(100);
    triangulator.append(polygon, outline, triangles);
    EXPECT_EQ(triangles.size(), 198u);
    EXPECT_EQ(triangulator.fanned(), 1u);
}

}  // namespace
}  // namespace ossuary::test
