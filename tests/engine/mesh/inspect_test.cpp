#include "engine/mesh/inspect.h"

#include <gtest/gtest.h>

#include "tests/engine/mesh/built_meshes.h"

namespace ossuary::test {
namespace {

TEST(Inspect, KnowsTheGenusOfClosedSurfaces) {
    EXPECT_EQ(mesh::inspect(cube_mesh()).genus, 0);
    EXPECT_EQ(mesh::inspect(sphere_mesh()).genus, 0);
    EXPECT_EQ(mesh::inspect(torus_mesh()).genus, 1);
    const mesh::MeshReport two = mesh::inspect(joined(torus_mesh(), torus_mesh()));
    EXPECT_EQ(two.components, 2u);
    EXPECT_EQ(two.genus, 2);
    EXPECT_EQ(two.euler_characteristic, 0);
}

TEST(Inspect, CountsTheElementsOfACube) {
    const mesh::MeshReport report = mesh::inspect(cube_mesh());
    EXPECT_EQ(report.vertices, 8u);
    EXPECT_EQ(report.edges, 18u);
    EXPECT_EQ(report.triangles, 12u);
    EXPECT_EQ(report.euler_characteristic, 2);
    EXPECT_TRUE(report.closed && report.edge_manifold && report.manifold && report.oriented);
}

TEST(Inspect, CountsTheBoundaryOfAnOpenSurface) {
    const mesh::MeshReport report = mesh::inspect(square_mesh(5));
    EXPECT_FALSE(report.closed);
    EXPECT_TRUE(report.manifold);
    EXPECT_EQ(report.boundary_edges, 20u);
    EXPECT_EQ(report.euler_characteristic, 1);
    EXPECT_FALSE(report.genus.has_value());
}

TEST(Inspect, SeesASoupAsLooseTriangles) {
    const mesh::MeshReport report = mesh::inspect(as_soup(cube_mesh()));
    EXPECT_EQ(report.components, 12u);
    EXPECT_EQ(report.boundary_edges, 36u);
}

TEST(Inspect, FindsNonManifoldEdgesAndVertices) {
    mesh::TriangleMesh fin = cube_mesh();
    fin.vertices.emplace_back(-1, -1, 0.5);
    fin.triangles.push_back({0, 4, 8});
    const mesh::MeshReport edge = mesh::inspect(fin);
    EXPECT_EQ(edge.non_manifold_edges, 1u);
    EXPECT_FALSE(edge.edge_manifold || edge.manifold);

    mesh::TriangleMesh tips = joined(corner_tetrahedron(), corner_tetrahedron());
    for (auto& triangle : tips.triangles) {
        for (auto& vertex : triangle) vertex = vertex == 4 ? 0 : vertex;
    }
    const mesh::MeshReport vertex = mesh::inspect(tips);
    EXPECT_EQ(vertex.non_manifold_edges, 0u);
    EXPECT_EQ(vertex.non_manifold_vertices, 1u);
    EXPECT_EQ(vertex.components, 1u);
    EXPECT_EQ(vertex.unreferenced_vertices, 1u);
    EXPECT_TRUE(vertex.edge_manifold);
    EXPECT_FALSE(vertex.manifold);
}

TEST(Inspect, FindsEachTriangleThatIsTurnedOver) {
    mesh::TriangleMesh mesh = sphere_mesh();
    std::swap(mesh.triangles[5][0], mesh.triangles[5][1]);
    const mesh::MeshReport report = mesh::inspect(mesh);
    EXPECT_EQ(report.misoriented_edges, 3u);
    EXPECT_FALSE(report.oriented);
    EXPECT_TRUE(report.closed);
    // No way of turning helps a Moebius band.
    EXPECT_GT(mesh::inspect(moebius_mesh()).misoriented_edges, 0u);
}

TEST(Inspect, CountsDegenerateFacesOfAPolygonOnce) {
    mesh::TriangleMesh mesh = cube_mesh();
    mesh.triangles.push_back({1, 1, 2});
    mesh.triangles.push_back({3, 3, 3});
    mesh.face_of_triangle.insert(mesh.face_of_triangle.end(), {12, 12});
    mesh.face_count = 13;
    const mesh::MeshReport report = mesh::inspect(mesh);
    EXPECT_EQ(report.degenerate_faces, 1u);
    EXPECT_TRUE(report.closed) << "triangles that name a vertex twice have no edges";
    EXPECT_EQ(report.euler_characteristic, 2);
}

TEST(Inspect, DoesNotDependOnNumbering) {
    mesh::TriangleMesh mesh = joined(torus_mesh(8, 6), as_soup(cube_mesh()));
    mesh.triangles.push_back({0, 1, 40});
    mesh = with_faces(mesh);
    const mesh::MeshReport a = mesh::inspect(mesh);
    const mesh::MeshReport b = mesh::inspect(renumbered(mesh, 11));
    EXPECT_EQ(a.edges, b.edges);
    EXPECT_EQ(a.boundary_edges, b.boundary_edges);
    EXPECT_EQ(a.non_manifold_edges, b.non_manifold_edges);
    EXPECT_EQ(a.misoriented_edges, b.misoriented_edges);
    EXPECT_EQ(a.non_manifold_vertices, b.non_manifold_vertices);
    EXPECT_EQ(a.components, b.components);
    EXPECT_EQ(a.euler_characteristic, b.euler_characteristic);
}

TEST(Inspect, TakesAnEmptyMesh) {
    const mesh::MeshReport report = mesh::inspect(mesh::TriangleMesh{});
    EXPECT_FALSE(report.closed);
    EXPECT_EQ(report.components, 0u);
    ASSERT_EQ(mesh::surface_warnings(mesh::TriangleMesh{}).size(), 1u);
    EXPECT_EQ(mesh::surface_warnings(mesh::TriangleMesh{})[0].code, "no_triangles");
}

TEST(SurfaceWarnings, SayNothingOfASoundSurface) {
    EXPECT_TRUE(mesh::surface_warnings(torus_mesh()).empty());
}

}  // namespace
}  // namespace ossuary::test
