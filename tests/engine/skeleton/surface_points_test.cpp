#include "engine/skeleton/surface_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/skeleton/skeletonize.h"
#include "tests/support/shapes.h"

namespace ossuary::skeleton {
namespace {

/// Each triangle with vertices of its own, moved by up to `jitter`, and some that none uses.
mesh::TriangleMesh soup_of(const mesh::TriangleMesh& mesh, double jitter = 0.0) {
    mesh::TriangleMesh soup = mesh;
    soup.vertices.assign(100, mesh.vertices[0] + Vec3(0.1, 0.2, 0.3));
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto first = static_cast<std::uint32_t>(soup.vertices.size());
        for (const Vec3& corner : mesh.corners(t)) {
            const double turn = static_cast<double>(soup.vertices.size());
            soup.vertices.push_back(corner + jitter * Vec3(std::sin(turn), std::cos(turn), 0));
        }
        soup.triangles[t] = {first, first + 1, first + 2};
    }
    return soup;
}

std::vector<Vec3> sorted(std::vector<Vec3> points) {
    std::sort(points.begin(), points.end(), [](const Vec3& a, const Vec3& b) {
        return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
    });
    return points;
}

TEST(SurfacePoints, AreThePlacesThatTrianglesUseOnceEach) {
    const mesh::TriangleMesh ball = test::icosphere_mesh({0, 0, 0}, 20, 2);
    WorldFromGrid grid;
    grid.origin = Vec3(-1, 2, 3);
    grid.voxel_size = 0.5;
    const std::vector<Vec3> points = surface_points(ball, grid);
    ASSERT_EQ(points.size(), ball.vertices.size());
    for (std::size_t v = 0; v < points.size(); ++v) {
        EXPECT_EQ(points[v], grid.grid(ball.vertices[v]));
    }
    EXPECT_EQ(sorted(surface_points(soup_of(ball), grid)), sorted(points));
    EXPECT_EQ(sorted(surface_points(test::renumbered(soup_of(ball), 3), grid)), sorted(points));
    EXPECT_NEAR(static_cast<double>(surface_points(soup_of(ball, 1e-9), grid).size()),
                static_cast<double>(points.size()), 3);
    EXPECT_TRUE(surface_points({}, grid).empty());
}

TEST(SurfacePoints, GiveASoupTheSignificancesOfTheModel) {
    const mesh::TriangleMesh tree = test::capsule_tree_mesh();
    const auto model = skeletonize(tree);
    const auto soup = skeletonize(soup_of(tree));
    ASSERT_TRUE(model.ok() && soup.ok());
    ASSERT_EQ(soup->refined.nodes.size(), model->refined.nodes.size());
    for (std::size_t i = 0; i < model->refined.nodes.size(); ++i) {
        EXPECT_GT(model->refined.nodes[i].significance, 0.0);
        EXPECT_EQ(soup->refined.nodes[i].significance, model->refined.nodes[i].significance);
    }
}

}  // namespace
}  // namespace ossuary::skeleton
