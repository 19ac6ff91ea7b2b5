#include "engine/mesh/weld.h"

#include <gtest/gtest.h>

#include "engine/mesh/components.h"
#include "engine/mesh/inspect.h"
#include "engine/mesh/measures.h"
#include "tests/engine/mesh/built_meshes.h"

namespace ossuary::test {
namespace {

TEST(Weld, ClosesASoup) {
    const mesh::TriangleMesh torus = torus_mesh();
    const mesh::WeldResult welded = mesh::weld(as_soup(torus));
    EXPECT_EQ(welded.mesh.vertices.size(), torus.vertices.size());
    EXPECT_EQ(welded.merged_vertices, 3 * torus.triangles.size() - torus.vertices.size());
    EXPECT_EQ(welded.dropped_triangles, 0u);
    EXPECT_EQ(mesh::inspect(welded.mesh).genus, 1);
    EXPECT_DOUBLE_EQ(mesh::measure(welded.mesh).surface_area, mesh::measure(torus).surface_area);
}

TEST(Weld, LeavesSeparatePiecesApart) {
    const mesh::TriangleMesh pieces =
        as_soup(joined(cube_mesh(), moved(cube_mesh(), Mat3::Identity(), 1, Vec3(3, 0, 0))));
    EXPECT_EQ(mesh::connected_components(mesh::weld(pieces).mesh).count, 2u);
}

TEST(Weld, TakesNegativeZeroForZero) {
    mesh::TriangleMesh mesh;
    mesh.vertices = {Vec3(0.0, 1, 2), Vec3(-0.0, 1, 2), Vec3(1, 1, 1), Vec3(2, 2, 0)};
    mesh.triangles = {{0, 2, 3}, {1, 3, 2}};
    EXPECT_EQ(mesh::weld(mesh).mesh.vertices.size(), 3u);
}

TEST(Weld, JoinsVerticesWithinTheToleranceOnly) {
    mesh::TriangleMesh soup = as_soup(sphere_mesh());
    std::mt19937_64 random(12);
    for (Vec3& vertex : soup.vertices) {
        for (double& x : vertex) x += uniform(random, -1e-6, 1e-6);
    }
    EXPECT_EQ(mesh::weld(soup).merged_vertices, 0u);
    mesh::WeldOptions options;
    options.tolerance = 1e-5;
    EXPECT_EQ(mesh::inspect(mesh::weld(soup, options).mesh).genus, 0);
    EXPECT_EQ(mesh::weld(soup, options).mesh.vertices.size(), sphere_mesh().vertices.size());
    options.tolerance = 1e-8;
    EXPECT_EQ(mesh::weld(soup, options).merged_vertices, 0u);
}

TEST(Weld, JoinsAcrossTheBordersOfItsCells) {
    // Pairs of points that straddle a multiple of the tolerance along each axis.
    mesh::TriangleMesh mesh;
    mesh.vertices = {Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(0.0999, 0.0999, 0.0999),
                     Vec3(0.1001, 0.1, 0.1), Vec3(0.5, 0.2, 0.9)};
    mesh.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
    mesh::WeldOptions options;
    options.tolerance = 0.1 / std::sqrt(3.0);
    EXPECT_EQ(mesh::weld(mesh, options).merged_vertices, 1u);
}

TEST(Weld, SaysWhereItsTrianglesComeFromAndDropsCollapsedOnes) {
    mesh::TriangleMesh mesh;
    mesh.vertices = {Vec3(9, 9, 9), Vec3(0, 0, 0), Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    mesh.triangles = {{1, 2, 3}, {2, 3, 4}};
    mesh = with_faces(mesh);
    const mesh::WeldResult welded = mesh::weld(mesh);
    EXPECT_EQ(welded.mesh.vertices.size(), 3u) << "the unused vertex is left out";
    EXPECT_EQ(welded.dropped_triangles, 1u);
    EXPECT_EQ(welded.source_triangle, (std::vector<std::uint32_t>{1}));
    EXPECT_EQ(welded.mesh.face_of_triangle, (std::vector<std::uint32_t>{1}));
    EXPECT_EQ(welded.mesh.face_count, 2u);
    mesh::WeldOptions options;
    options.drop_collapsed = false;
    EXPECT_EQ(mesh::weld(mesh, options).mesh.triangles.size(), 2u);
}

TEST(Weld, DoesNotLetAFarUnusedVertexDisturbTheTolerance) {
    mesh::TriangleMesh mesh = as_soup(cube_mesh());
    mesh.vertices.emplace_back(1e90, -1e90, 1e90);
    mesh::WeldOptions options;
    options.tolerance = 1e-6;
    EXPECT_EQ(mesh::weld(mesh, options).mesh.vertices.size(), 8u);
}

TEST(ConnectedComponents, AreNumberedByTheirFirstTriangle) {
    const mesh::TriangleMesh mesh =
        joined(joined(cube_mesh(), corner_tetrahedron()), sphere_mesh(0));
    const mesh::MeshComponents components = mesh::connected_components(mesh);
    EXPECT_EQ(components.count, 3u);
    for (std::size_t t = 0; t < 24; ++t) {
        EXPECT_EQ(components.of_triangle[t], t < 12 ? 0u : t < 16 ? 1u : 2u);
    }
    EXPECT_EQ(mesh::connected_components(mesh::TriangleMesh{}).count, 0u);
}

}  // namespace
}  // namespace ossuary::test
