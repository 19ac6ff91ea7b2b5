#include "engine/mesh/orient.h"

#include <gtest/gtest.h>

#include "engine/mesh/inspect.h"
#include "engine/mesh/measures.h"
#include "tests/engine/mesh/built_meshes.h"

namespace ossuary::test {
namespace {

TEST(Orient, LeavesSoundSurfacesAlone) {
    for (const mesh::TriangleMesh& mesh :
         {cube_mesh(), torus_mesh(), square_mesh(4), sphere_mesh()}) {
        const mesh::OrientResult result = mesh::orient(mesh);
        EXPECT_EQ(result.flipped_triangles, 0u);
        EXPECT_EQ(result.mesh.triangles, mesh.triangles);
    }
}

TEST(Orient, TurnsEveryPatchOutwards) {
    std::mt19937_64 random(13);
    mesh::TriangleMesh mesh =
        joined(torus_mesh(), moved(sphere_mesh(), some_rotation(), 1, Vec3(9, 0, 0)));
    const double volume = mesh::measure(mesh).signed_volume;
    std::size_t turned = 0;
    for (auto& triangle : mesh.triangles) {
        if (random() % 2 == 0) continue;
        std::swap(triangle[0], triangle[1]);
        ++turned;
    }
    const mesh::OrientResult result = mesh::orient(mesh);
    EXPECT_EQ(result.flipped_triangles, turned);
    EXPECT_EQ(result.unorientable_edges, 0u);
    EXPECT_TRUE(mesh::inspect(result.mesh).oriented);
    EXPECT_NEAR(mesh::measure(result.mesh).signed_volume, volume, 1e-9);
}

TEST(Orient, TurnsAnInsideOutSurface) {
    mesh::TriangleMesh mesh = sphere_mesh();
    for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    EXPECT_GT(mesh::measure(mesh::orient(mesh).mesh).signed_volume, 0);
}

TEST(Orient, ReportsWhatCannotAgree) {
    EXPECT_GT(mesh::orient(moebius_mesh()).unorientable_edges, 0u);
    EXPECT_EQ(mesh::orient(moebius_mesh()).mesh.triangles.size(), moebius_mesh().triangles.size());
}

}  // namespace
}  // namespace ossuary::test
