#include "engine/mesh/halfedge_mesh.h"

#include <gtest/gtest.h>

#include <set>

#include "engine/mesh/inspect.h"
#include "engine/mesh/measures.h"
#include "tests/engine/mesh/built_meshes.h"

namespace ossuary::test {
namespace {

void expect_all_triangles_kept(const mesh::TriangleMesh& mesh, std::size_t degenerate) {
    const mesh::HalfedgeMesh surface(mesh);
    EXPECT_EQ(surface.report().dropped_triangles, degenerate);
    EXPECT_EQ(surface.triangle_count(), mesh.triangles.size() - degenerate);
    const mesh::TriangleMesh back = surface.to_triangle_mesh();
    EXPECT_NEAR(mesh::measure(back).surface_area, mesh::measure(mesh).surface_area,
                1e-12 * mesh::measure(mesh).surface_area);
    const mesh::MeshReport report = mesh::inspect(back);
    EXPECT_TRUE(report.manifold);
    EXPECT_TRUE(report.oriented);
    for (std::uint32_t v = 0; v < surface.vertex_count(); ++v) {
        EXPECT_EQ(back.vertices[v], mesh.vertices[surface.source_vertex(v)]);
    }
}

TEST(HalfedgeMesh, HoldsASoundSurfaceAsItIs) {
    const mesh::TriangleMesh torus = torus_mesh();
    const mesh::HalfedgeMesh surface(torus);
    EXPECT_EQ(surface.report().duplicated_vertices, 0u);
    EXPECT_EQ(surface.report().detached_triangles, 0u);
    EXPECT_EQ(surface.vertex_count(), torus.vertices.size());
    EXPECT_EQ(surface.edge_count(), mesh::inspect(torus).edges);
    EXPECT_EQ(surface.boundary_loop_count(), 0u);
    expect_all_triangles_kept(torus, 0);
}

TEST(HalfedgeMesh, CountsBoundaryLoops) {
    EXPECT_EQ(mesh::HalfedgeMesh(square_mesh(3)).boundary_loop_count(), 1u);
    mesh::TriangleMesh ring = torus_mesh(12, 8);
    ring.triangles.resize(ring.triangles.size() - 16);
    EXPECT_EQ(mesh::HalfedgeMesh(with_faces(ring)).boundary_loop_count(), 2u);
}

TEST(HalfedgeMesh, WalksAroundAVertex) {
    const mesh::HalfedgeMesh surface(square_mesh(2));
    std::size_t inner = 0;
    for (std::uint32_t v = 0; v < surface.vertex_count(); ++v) {
        if (surface.is_boundary(v)) continue;
        ++inner;
        const auto ring = surface.one_ring(v);
        EXPECT_EQ(std::set(ring.begin(), ring.end()).size(), 6u);
    }
    EXPECT_EQ(inner, 1u);
}

TEST(HalfedgeMesh, KeepsTheTrianglesOfNonManifoldEdges) {
    mesh::TriangleMesh book;
    book.vertices = {Vec3(0, 0, 0), Vec3(0, 0, 1)};
    for (int page = 0; page < 7; ++page) {
        book.vertices.emplace_back(std::cos(page), std::sin(page), 0.5);
        book.triangles.push_back({0, 1, std::uint32_t(page + 2)});
    }
    expect_all_triangles_kept(with_faces(book), 0);
}

TEST(HalfedgeMesh, PartsFansThatMeetInAVertex) {
    mesh::TriangleMesh tips = joined(corner_tetrahedron(), corner_tetrahedron());
    for (auto& triangle : tips.triangles) {
        for (auto& vertex : triangle) vertex = vertex == 4 ? 0 : vertex;
    }
    EXPECT_EQ(mesh::HalfedgeMesh(tips).report().duplicated_vertices, 1u);
    expect_all_triangles_kept(tips, 0);
}

TEST(HalfedgeMesh, KeepsTheTrianglesOfMisorientedAndTwistedSurfaces) {
    mesh::TriangleMesh mesh = sphere_mesh();
    for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
        std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
    }
    expect_all_triangles_kept(mesh, 0);
    expect_all_triangles_kept(moebius_mesh(), 0);
}

TEST(HalfedgeMesh, DropsOnlyTrianglesThatNameAVertexTwice) {
    mesh::TriangleMesh mesh = cube_mesh();
    mesh.triangles.push_back({1, 1, 2});
    mesh.triangles.push_back({0, 3, 0});
    expect_all_triangles_kept(with_faces(mesh), 2);
}

TEST(HalfedgeMesh, KeepsRandomSoups) {
    std::mt19937_64 random(14);
    for (int round = 0; round < 200; ++round) {
        mesh::TriangleMesh mesh;
        for (int v = 0; v < 9; ++v) {
            mesh.vertices.emplace_back(uniform(random, 0, 1), uniform(random, 0, 1),
                                       uniform(random, 0, 1));
        }
        std::size_t degenerate = 0;
        for (int t = 0; t < 25; ++t) {
            const mesh::TriangleMesh::Triangle triangle = {std::uint32_t(random() % 9),
                                                           std::uint32_t(random() % 9),
                                                           std::uint32_t(random() % 9)};
            mesh.triangles.push_back(triangle);
            degenerate += triangle[0] == triangle[1] || triangle[1] == triangle[2] ||
                                  triangle[2] == triangle[0]
                              ? 1
                              : 0;
        }
        expect_all_triangles_kept(with_faces(mesh), degenerate);
    }
}

TEST(HalfedgeMesh, TakesAnEmptyMesh) {
    mesh::HalfedgeMesh surface{mesh::TriangleMesh{}};
    EXPECT_EQ(surface.triangle_count(), 0u);
    EXPECT_EQ(surface.decimate_quadric(10), 0u);
    EXPECT_TRUE(surface.to_triangle_mesh().empty());
}

TEST(HalfedgeMesh, KeepsTopologyAndShapeWhenDecimated) {
    mesh::HalfedgeMesh surface(torus_mesh(64, 32));
    EXPECT_LE(surface.decimate_quadric(400), 400u);
    const mesh::TriangleMesh coarse = surface.to_triangle_mesh();
    EXPECT_EQ(mesh::inspect(coarse).genus, 1);
    EXPECT_NEAR(mesh::measure(coarse).signed_volume,
                mesh::measure(torus_mesh(64, 32)).signed_volume,
                0.05 * mesh::measure(torus_mesh()).signed_volume);
}

}  // namespace
}  // namespace ossuary::test
