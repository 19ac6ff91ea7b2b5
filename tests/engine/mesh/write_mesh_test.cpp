#include "engine/mesh/write_mesh.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <sstream>

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

TEST(WriteOff, SaysWhenAFileCannotBeWritten) {
    const auto written = mesh::write_off(cube_mesh(), "/nowhere/at/all/cube.off");
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code, ErrorCode::kFileUnwritable);
    // The disk that is always full accepts the open and refuses the bytes.
    EXPECT_FALSE(mesh::write_obj(sphere_mesh(5), "/dev/full"));
}

}  // namespace
}  // namespace ossuary::test
