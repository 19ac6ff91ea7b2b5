#include "engine/mesh/measures.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/engine/mesh/built_meshes.h"

namespace ossuary::test {
namespace {

TEST(Measure, KnowsACube) {
    const mesh::MeshMeasures cube = mesh::measure(cube_mesh(2));
    EXPECT_DOUBLE_EQ(cube.surface_area, 24);
    EXPECT_DOUBLE_EQ(cube.signed_volume, 8);
    EXPECT_TRUE(cube.area_centroid.isApprox(Vec3(1, 1, 1)));
    EXPECT_EQ(cube.bounds.min(), Vec3(0, 0, 0));
    EXPECT_EQ(cube.bounds.max(), Vec3(2, 2, 2));
    EXPECT_DOUBLE_EQ(cube.diagonal, std::sqrt(12.0));
}

TEST(Measure, ApproachesTheSphereAndTheTorus) {
    using std::numbers::pi;
    EXPECT_NEAR(mesh::measure(sphere_mesh(5)).surface_area, 4 * pi, 0.01);
    EXPECT_NEAR(mesh::measure(sphere_mesh(5)).signed_volume, 4 * pi / 3, 0.01);
    EXPECT_NEAR(mesh::measure(torus_mesh(200, 100, 2, 0.5)).signed_volume, 2 * pi * pi * 2 * 0.25,
                0.02);
}

TEST(Measure, ScalesWithTheModelAndIgnoresItsPlace) {
    const mesh::MeshMeasures here = mesh::measure(torus_mesh());
    // Far enough away to cancel out all digits of a naive volume.
    const mesh::MeshMeasures there =
        mesh::measure(moved(torus_mesh(), some_rotation(), 3.0, Vec3(1e7, -2e7, 1e7)));
    EXPECT_NEAR(there.surface_area / here.surface_area, 9, 1e-6);
    EXPECT_NEAR(there.signed_volume / here.signed_volume, 27, 1e-5);
    EXPECT_NEAR((there.area_centroid - Vec3(1e7, -2e7, 1e7)).norm(), 0, 1e-6);
}

TEST(Measure, ChangesTheSignOfTheVolumeWithTheOrientation) {
    mesh::TriangleMesh mesh = sphere_mesh();
    for (auto& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
    EXPECT_NEAR(mesh::measure(mesh).signed_volume, -mesh::measure(sphere_mesh()).signed_volume,
                1e-12);
}

TEST(Measure, IgnoresVerticesThatNoTriangleUses) {
    mesh::TriangleMesh mesh = cube_mesh();
    mesh.vertices.emplace_back(100, 100, 100);
    EXPECT_EQ(mesh::measure(mesh).bounds.max(), Vec3(1, 1, 1));
}

TEST(Measure, IgnoresFacesWithoutAreaWhereOthersHaveSome) {
    mesh::TriangleMesh mesh = cube_mesh();
    const mesh::MeshMeasures cube = mesh::measure(mesh);
    mesh.vertices.emplace_back(100, 100, 100);
    mesh.vertices.emplace_back(50, 50, 50);
    mesh.triangles.push_back({8, 8, 8});
    mesh.triangles.push_back({0, 8, 8});
    mesh.triangles.push_back({0, 9, 8});
    const mesh::MeshMeasures measures = mesh::measure(mesh);
    EXPECT_EQ(measures.bounds.max(), cube.bounds.max());
    EXPECT_EQ(measures.area_centroid, cube.area_centroid);
    EXPECT_EQ(measures.surface_area, cube.surface_area);
    EXPECT_EQ(measures.diagonal, cube.diagonal);
    mesh.triangles.erase(mesh.triangles.begin(), mesh.triangles.begin() + 12);
    EXPECT_EQ(mesh::measure(mesh).bounds.max(), Vec3(100, 100, 100));
}

TEST(Measure, TakesMeshesWithoutTrianglesOrArea) {
    EXPECT_TRUE(mesh::measure(mesh::TriangleMesh{}).bounds.isEmpty());
    EXPECT_EQ(mesh::measure(mesh::TriangleMesh{}).diagonal, 0.0);
    mesh::TriangleMesh point;
    point.vertices = {Vec3(5, 6, 7)};
    point.triangles = {{0, 0, 0}};
    EXPECT_EQ(mesh::measure(point).area_centroid, Vec3(5, 6, 7));
    EXPECT_EQ(mesh::measure(point).surface_area, 0.0);
}

TEST(IsDegenerate, DoesNotDependOnScale) {
    for (const double scale : {1e-50, 1.0, 1e50}) {
        mesh::TriangleMesh mesh;
        mesh.vertices = {scale * Vec3(0, 0, 0), scale * Vec3(1, 0, 0), scale * Vec3(0.3, 1e-6, 0),
                         scale * Vec3(0.5, 0, 0)};
        mesh.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 0, 1}};
        EXPECT_FALSE(mesh::is_degenerate(mesh, 0)) << scale;
        EXPECT_TRUE(mesh::is_degenerate(mesh, 1)) << scale;
        EXPECT_TRUE(mesh::is_degenerate(mesh, 2)) << scale;
    }
}

}  // namespace
}  // namespace ossuary::test
