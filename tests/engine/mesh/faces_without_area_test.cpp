#include "engine/mesh/faces_without_area.h"

#include <gtest/gtest.h>

#include "engine/mesh/inspect.h"
#include "tests/support/shapes.h"

namespace ossuary::mesh {
namespace {

std::uint32_t add_vertex(TriangleMesh& mesh, const Vec3& position) {
    mesh.vertices.push_back(position);
    return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

void add_triangle(TriangleMesh& mesh, const TriangleMesh::Triangle& triangle) {
    mesh.triangles.push_back(triangle);
    mesh.face_of_triangle.push_back(mesh.face_count++);
}

const TriangleMesh kBox = test::box_mesh({0, 0, 0}, {4, 2, 1});

TEST(WithoutEmptyFaces, LeavesAMeshAloneWhereEveryFaceHasArea) {
    EXPECT_FALSE(without_empty_faces(kBox).mesh.has_value());
    EXPECT_FALSE(without_empty_faces({}).mesh.has_value());
}

TEST(WithoutEmptyFaces, TakesOutPointsAndLinesWhereverTheyAre) {
    for (const double distance : {0.5, 8.0, 8e3, 8e6}) {
        TriangleMesh mesh = kBox;
        const std::uint32_t a = add_vertex(mesh, {distance, 1, 0.5});
        const std::uint32_t b = add_vertex(mesh, {distance, 1, 0.5});
        const std::uint32_t c = add_vertex(mesh, {2 * distance, 2, 1});
        const std::uint32_t d = add_vertex(mesh, {3 * distance, 3, 1.5});
        add_triangle(mesh, {a, a, a});  // a point
        add_triangle(mesh, {a, b, b});
        add_triangle(mesh, {a, c, c});  // a line
        add_triangle(mesh, {a, c, d});  // a needle
        add_triangle(mesh, {0, c, c});  // a line from the box
        add_triangle(mesh, {0, 6, 0});  // across it
        const WithoutEmptyFaces result = without_empty_faces(mesh);
        ASSERT_TRUE(result.mesh.has_value()) << distance;
        EXPECT_EQ(result.mesh->triangles, kBox.triangles) << distance;
        EXPECT_EQ(result.mesh->face_of_triangle, kBox.face_of_triangle) << distance;
        EXPECT_EQ(result.mesh->vertices, mesh.vertices);
        EXPECT_EQ(result.removed, 6u);
    }
}

TEST(WithoutEmptyFaces, TakesOutWhatHangsOnOthersThatHang) {
    TriangleMesh mesh = kBox;
    // A strip of needles along a line away from a corner, the last one double.
    std::uint32_t before = 0;
    std::uint32_t last = add_vertex(mesh, {-1, 0, 0});
    for (int i = 2; i < 9; ++i) {
        const std::uint32_t next = add_vertex(mesh, {-1.0 * i, 0, 0});
        add_triangle(mesh, {before, last, next});
        before = last;
        last = next;
    }
    add_triangle(mesh, {before, last, mesh.triangles.back()[0]});
    const WithoutEmptyFaces result = without_empty_faces(mesh);
    ASSERT_TRUE(result.mesh.has_value());
    EXPECT_EQ(result.mesh->triangles, kBox.triangles);
}

/// The box with one edge of one of its faces split in the middle, and a needle in the slit.
TriangleMesh box_with_needle() {
    TriangleMesh mesh = kBox;
    const TriangleMesh::Triangle t = mesh.triangles[0];
    const std::uint32_t middle = add_vertex(mesh, (mesh.vertices[t[0]] + mesh.vertices[t[1]]) / 2);
    mesh.triangles[0] = {t[0], middle, t[2]};
    add_triangle(mesh, {middle, t[1], t[2]});
    add_triangle(mesh, {t[0], t[1], middle});
    return mesh;
}

TEST(WithoutEmptyFaces, KeepsWhatClosesASurface) {
    const TriangleMesh mesh = box_with_needle();
    ASSERT_TRUE(inspect(mesh).closed);
    EXPECT_FALSE(without_empty_faces(mesh).mesh.has_value());

    TriangleMesh soup;  // the same where every triangle has vertices of its own
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (const Vec3& corner : mesh.corners(t)) add_vertex(soup, corner);
        const auto end = static_cast<std::uint32_t>(soup.vertices.size());
        add_triangle(soup, {end - 3, end - 2, end - 1});
    }
    EXPECT_FALSE(without_empty_faces(soup).mesh.has_value());
}

TEST(WithoutEmptyFaces, DrawsInASpikeWithoutAreaAndStaysClosed) {
    TriangleMesh mesh = box_with_needle();
    const TriangleMesh::Triangle needle = mesh.triangles.back();
    mesh.triangles.pop_back();
    mesh.face_of_triangle.pop_back();
    // The needle becomes three, around a vertex far out on its line.
    const Vec3 direction = mesh.vertices[needle[1]] - mesh.vertices[needle[0]];
    const std::uint32_t tip = add_vertex(mesh, mesh.vertices[needle[0]] + 1e5 * direction);
    for (std::size_t k = 0; k < 3; ++k) {
        add_triangle(mesh, {needle[k], needle[(k + 1) % 3], tip});
    }
    ASSERT_TRUE(inspect(mesh).closed);
    const WithoutEmptyFaces result = without_empty_faces(mesh);
    ASSERT_TRUE(result.mesh.has_value());
    EXPECT_EQ(result.removed, 2u);
    EXPECT_TRUE(inspect(*result.mesh).closed);
    for (const TriangleMesh::Triangle& triangle : result.mesh->triangles) {
        for (const std::uint32_t v : triangle) EXPECT_NE(v, tip);
    }
}

TEST(WithoutEmptyFaces, TakesAModelOfLinesAsItIs) {
    TriangleMesh lines;
    for (int i = 0; i < 3; ++i) add_vertex(lines, {1.0 * i, 0.5 * i * i, 0});
    add_triangle(lines, {0, 1, 1});
    add_triangle(lines, {1, 2, 2});
    EXPECT_FALSE(without_empty_faces(lines).mesh.has_value());
}

}  // namespace
}  // namespace ossuary::mesh
