#include "engine/mesh/nearest_triangle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "engine/mesh/vertex_normals.h"

namespace ossuary::mesh {
namespace {

/// In [-1, 1), the same on every platform.
double next_number(std::mt19937_64& random) {
    return static_cast<double>(random() >> 11) * 0x1p-52 - 1.0;
}

Vec3 next_point(std::mt19937_64& random) {
    const double x = next_number(random), y = next_number(random);
    return {x, y, next_number(random)};
}

/// Triangles of all sizes and shapes; some are lines or points, each third lies on another.
TriangleMesh heap_of_triangles(int count) {
    std::mt19937_64 random(7);
    TriangleMesh mesh;
    for (int t = 0; t < count; ++t) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        const Vec3 place = next_point(random);
        const double size = std::pow(10.0, -2.0 + next_number(random));
        for (int corner = 0; corner < 3; ++corner) {
            mesh.vertices.push_back(place + size * next_point(random));
        }
        mesh.triangles.push_back({first, first + 1, first + 2});
        if (t % 7 == 0) mesh.triangles.push_back({first, first + 1, first + 1});
        if (t % 11 == 0) mesh.triangles.push_back({first, first, first});
        if (t % 3 == 0) mesh.triangles.push_back({first, first + 2, first + 1});
    }
    return mesh;
}

TEST(NearestTriangle, AgreesWithLookingAtAll) {
    const TriangleMesh mesh = heap_of_triangles(300);
    const std::vector<Vec3> normals = triangle_normals(mesh);
    for (const double turned_distance : {0.0, 0.01, 1.0}) {
        const NearestTriangle nearest(mesh, turned_distance);
        std::mt19937_64 random(3);
        for (int query = 0; query < 500; ++query) {
            const Vec3 point = 1.5 * next_point(random);
            const Vec3 normal = next_point(random).normalized();
            double best = std::numeric_limits<double>::infinity();
            std::uint32_t expected = 0;
            for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
                const double cost =
                    (nearest_point_of(mesh.corners(t), point) - point).squaredNorm() +
                    turned_distance * turned_distance / 2.0 * (1.0 - normal.dot(normals[t]));
                if (cost < best) {
                    best = cost;
                    expected = t;
                }
            }
            ASSERT_EQ(nearest.of(point, normal), expected) << query;
        }
    }
}

TEST(NearestTriangle, NearestPointsOfATriangleAreOfItAndNoneOfItsPointsIsNearer) {
    const TriangleMesh mesh = heap_of_triangles(60);
    std::mt19937_64 random(5);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto corners = mesh.corners(t);
        const auto& [a, b, c] = corners;
        const double size = (b - a).norm() + (c - a).norm();
        const Vec3 point = a + 2.0 * size * next_point(random);
        const Vec3 nearest = nearest_point_of(corners, point);
        const double distance = (nearest - point).norm();
        EXPECT_LE((nearest_point_of(corners, nearest) - nearest).norm(), 1e-12 + 1e-9 * size);
        for (int i = 0; i <= 20; ++i) {
            for (int j = 0; j <= 20 - i; ++j) {
                const Vec3 other = a + (b - a) * (i / 20.0) + (c - a) * (j / 20.0);
                EXPECT_LE(distance, (other - point).norm() + 1e-12 + 1e-9 * size);
            }
        }
    }
}

TEST(NearestTriangle, OfSheetsThatLieTogetherTheOneThatFacesTheSameWayWins) {
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 2}};
    const NearestTriangle nearest(mesh, 1e-3);
    EXPECT_EQ(nearest.of({0.2, 0.2, 0.0}, {0, 0, 1}), 1U);
    EXPECT_EQ(nearest.of({0.2, 0.2, 0.0}, {0, 0, -1}), 0U);
    EXPECT_EQ(NearestTriangle(mesh).of({0.2, 0.2, 0.0}, {0, 0, 1}), 0U) << "the lower number";
}

TEST(NearestTriangle, FindsSomethingNearInAThicket) {
    // Slivers from face to face of a cube: nearly every box reaches nearly everywhere.
    std::mt19937_64 random(3);
    TriangleMesh mesh;
    for (std::uint32_t t = 0; t < 50'000; ++t) {
        const Vec3 from = next_point(random);
        const Vec3 to = next_point(random);
        for (const Vec3& corner : {from, to, Vec3(to + 1e-3 * next_point(random))}) {
            mesh.vertices.push_back(corner);
        }
        mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    const NearestTriangle nearest(mesh);
    for (int i = 0; i < 50; ++i) {
        const Vec3 point = 0.5 * next_point(random);
        const std::uint32_t found = nearest.of(point, Vec3::Zero());
        EXPECT_LT((nearest_point_of(mesh.corners(found), point) - point).norm(), 0.2);
        EXPECT_EQ(nearest.of(point, Vec3::Zero()), found);
    }
}

}  // namespace
}  // namespace ossuary::mesh
