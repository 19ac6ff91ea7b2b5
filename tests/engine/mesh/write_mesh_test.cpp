#include "engine/mesh/write_mesh.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <sstream>

#include "engine/mesh/measures.h"
#include "engine/mesh/read_mesh.h"
#include "tests/engine/mesh/built_meshes.h"

namespace ossuary::test {
namespace {

TEST(WriteOff, KeepsEveryBitOfEveryCoordinate) {
    std::mt19937_64 random(9);
    mesh::TriangleMesh mesh;
    for (int i = 0; i < 3000; ++i) {
        Vec3 vertex;
        for (double& x : vertex) {
            do {
                x = std::bit_cast<double>(random());
            } while (!(std::abs(x) < 1e30));
        }
        mesh.vertices.push_back(vertex);
    }
    mesh.triangles = {{0, 1, 2}, {2999, 5, 7}};
    const auto read = mesh::read_mesh(mesh::to_off(mesh), "written");
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->mesh.vertices, mesh.vertices);
    EXPECT_EQ(read->mesh.triangles, mesh.triangles);
}

TEST(WriteObj, CountsFromOne) {
    const mesh::TriangleMesh mesh = corner_tetrahedron();
    std::istringstream text(mesh::to_obj(mesh));
    std::size_t vertices = 0;
    std::size_t faces = 0;
    for (std::string key; text >> key;) {
        if (key == "v") {
            Vec3 position;
            text >> position[0] >> position[1] >> position[2];
            EXPECT_EQ(position, mesh.vertices[vertices++]);
        } else {
            ASSERT_EQ(key, "f");
            for (const std::uint32_t expected : mesh.triangles[faces]) {
                std::uint32_t index = 0;
                text >> index;
                EXPECT_EQ(index, expected + 1);
            }
            ++faces;
        }
    }
    EXPECT_EQ(vertices, 4u);
    EXPECT_EQ(faces, 4u);
}

/// A mesh whose coordinates floats hold, so that STL keeps them.
mesh::TriangleMesh float_sphere() {
    mesh::TriangleMesh sphere = sphere_mesh(3);
    for (Vec3& vertex : sphere.vertices) {
        for (double& x : vertex) {
            // GCC 12 leaves out the rounding where it vectorises the loop.
            const volatile float rounded = static_cast<float>(x);
            x = double{rounded};
        }
    }
    return sphere;
}

TEST(WriteMesh, ReadsBackTheSameTrianglesInEveryFormat) {
    const mesh::TriangleMesh sphere = float_sphere();
    for (const std::string& bytes :
         {mesh::to_off(sphere), mesh::to_obj(sphere), mesh::to_ply(sphere), mesh::to_stl(sphere)}) {
        const auto read = mesh::read_mesh(bytes, "written");
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_TRUE(read->warnings.empty());
        ASSERT_EQ(read->mesh.triangles.size(), sphere.triangles.size());
        EXPECT_EQ(read->mesh.vertices.size(), sphere.vertices.size());
        for (std::size_t t = 0; t < sphere.triangles.size(); ++t) {
            ASSERT_EQ(read->mesh.corners(t), sphere.corners(t)) << t;
        }
    }
}

TEST(WriteMesh, KeepsEveryBitOfDoublesInPly) {
    const mesh::TriangleMesh sphere = sphere_mesh(2);
    const auto read = mesh::read_mesh(mesh::to_ply(sphere), "written");
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->mesh.vertices, sphere.vertices);
    EXPECT_EQ(read->mesh.triangles, sphere.triangles);
}

TEST(WriteMesh, ReadsBackColouredFacesAndGroups) {
    const mesh::TriangleMesh cube = cube_mesh();
    const std::size_t count = cube.triangles.size();
    const std::vector<mesh::Colour> colours(count, mesh::Colour{255, 128, 0});
    std::vector<std::uint32_t> groups(count, 0);
    for (std::size_t t = 0; t < count; ++t) groups[t] = static_cast<std::uint32_t>(t % 3);
    const std::string obj = mesh::to_obj(cube, groups, "part");
    const std::string stl = mesh::to_stl(cube, groups, "part");
    EXPECT_NE(obj.find("g part2\n"), std::string::npos);
    EXPECT_NE(stl.find("endsolid part2\n"), std::string::npos);
    for (const std::string& bytes :
         {mesh::to_off(cube, colours), mesh::to_ply(cube, colours), obj, stl}) {
        const auto read = mesh::read_mesh(bytes, "written");
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_TRUE(read->warnings.empty());
        EXPECT_EQ(read->mesh.triangles.size(), count);
        EXPECT_EQ(read->mesh.vertices.size(), cube.vertices.size());
        EXPECT_DOUBLE_EQ(mesh::measure(read->mesh).surface_area, mesh::measure(cube).surface_area);
    }
}

TEST(WriteStl, GivesNormalsByTheRightHandRule) {
    const mesh::TriangleMesh tetrahedron = corner_tetrahedron();
    const std::string stl = mesh::to_stl(tetrahedron);
    for (std::size_t t = 0; t < tetrahedron.triangles.size(); ++t) {
        Vec3f normal;
        std::memcpy(normal.data(), stl.data() + 84 + 50 * t, sizeof(normal));
        const auto [a, b, c] = tetrahedron.corners(t);
        const Vec3 expected = (b - a).cross(c - a).normalized();
        EXPECT_LT((normal.cast<double>() - expected).norm(), 1e-6);
    }
}

TEST(WriteOff, SaysWhenAFileCannotBeWritten) {
    const auto written = mesh::write_off(cube_mesh(), "/nowhere/at/all/cube.off");
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code, ErrorCode::kFileUnwritable);
    // The disk that is always full accepts the open and refuses the bytes.
    EXPECT_FALSE(mesh::write_obj(sphere_mesh(5), "/dev/full"));
}

}  // namespace
}  // namespace ossuary::test
