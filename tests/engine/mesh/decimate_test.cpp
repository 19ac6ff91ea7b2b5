#include "engine/mesh/decimate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/mesh/cluster_vertices.h"
#include "engine/mesh/inspect.h"
#include "engine/mesh/measures.h"
#include "engine/mesh/read_mesh.h"
#include "tests/engine/mesh/built_meshes.h"
#include "tests/support/benchmark_data.h"

namespace ossuary::test {
namespace {

void expect_sound(const mesh::TriangleMesh& mesh) {
    EXPECT_EQ(mesh::inspect(mesh).unreferenced_vertices, 0u);
    EXPECT_EQ(mesh.face_count, mesh.triangles.size());
    EXPECT_EQ(mesh.face_of_triangle.size(), mesh.triangles.size());
    for (const auto& triangle : mesh.triangles) {
        for (const auto vertex : triangle) ASSERT_LT(vertex, mesh.vertices.size());
    }
    for (const Vec3& vertex : mesh.vertices) ASSERT_TRUE(vertex.allFinite());
}

/// A cloud of small separate tetrahedra: no edge collapse can join them.
mesh::TriangleMesh cloud_of_pieces(int pieces) {
    std::mt19937_64 random(15);
    mesh::TriangleMesh cloud;
    for (int i = 0; i < pieces; ++i) {
        const Vec3 shift(uniform(random, 0, 1), uniform(random, 0, 1), uniform(random, 0, 1));
        cloud = joined(cloud, moved(corner_tetrahedron(), some_rotation(), 0.02, shift));
    }
    return cloud;
}

TEST(Decimate, KeepsMeshesThatAreSmallEnough) {
    const mesh::TriangleMesh cube = mesh::decimate(cube_mesh());
    EXPECT_EQ(cube.triangles.size(), 12u);
    EXPECT_EQ(cube.vertices.size(), 8u);
    EXPECT_TRUE(mesh::decimate(mesh::TriangleMesh{}).empty());
}

TEST(Decimate, ReachesTheBoundWithShapeAndTopology) {
    for (const std::size_t bound : {2000u, 500u, 100u}) {
        mesh::DecimateOptions options;
        options.max_triangles = bound;
        const mesh::TriangleMesh fine = torus_mesh(40, 40);
        const mesh::TriangleMesh coarse = mesh::decimate(fine, options);
        EXPECT_LE(coarse.triangles.size(), bound);
        EXPECT_GE(coarse.triangles.size(), bound / 2);
        expect_sound(coarse);
        EXPECT_NEAR(mesh::measure(coarse).surface_area, mesh::measure(fine).surface_area,
                    0.15 * mesh::measure(fine).surface_area);
        EXPECT_TRUE(mesh::inspect(coarse).closed);
    }
}

TEST(Decimate, ReachesTheBoundOnHugeMeshes) {
    const mesh::TriangleMesh fine = sphere_mesh(6);
    ASSERT_EQ(fine.triangles.size(), 32768u);
    const mesh::TriangleMesh coarse = mesh::decimate(fine);
    EXPECT_LE(coarse.triangles.size(), 2000u);
    EXPECT_GE(coarse.triangles.size(), 1500u);
    expect_sound(coarse);
    for (const Vec3& vertex : coarse.vertices) EXPECT_NEAR(vertex.norm(), 1.0, 0.02);
}

TEST(Decimate, ReachesTheBoundOnSoups) {
    const mesh::TriangleMesh cloud = cloud_of_pieces(1000);
    mesh::DecimateOptions options;
    options.max_triangles = 600;
    const mesh::TriangleMesh coarse = mesh::decimate(cloud, options);
    EXPECT_LE(coarse.triangles.size(), 600u);
    EXPECT_GE(coarse.triangles.size(), 60u);
    expect_sound(coarse);
    EXPECT_LT((mesh::measure(coarse).bounds.sizes() - mesh::measure(cloud).bounds.sizes()).norm(),
              0.25);

    const mesh::TriangleMesh loose = as_soup(sphere_mesh(5));
    options.max_triangles = 1000;
    EXPECT_LE(mesh::decimate(loose, options).triangles.size(), 1000u);
    EXPECT_TRUE(mesh::inspect(mesh::decimate(loose, options)).closed)
        << "coincident vertices are welded first";
}

TEST(Decimate, GivesTheSameBytesTwice) {
    const mesh::TriangleMesh mesh = joined(cloud_of_pieces(100), torus_mesh(60, 30));
    mesh::DecimateOptions options;
    options.max_triangles = 700;
    const mesh::TriangleMesh a = mesh::decimate(mesh, options);
    const mesh::TriangleMesh b = mesh::decimate(mesh, options);
    EXPECT_EQ(a.vertices, b.vertices);
    EXPECT_EQ(a.triangles, b.triangles);
}

TEST(Decimate, TakesAFanOfManyTriangles) {
    // Ten thousand slivers around one vertex, which a walk around each vertex would visit squared.
    mesh::TriangleMesh fan;
    fan.vertices.emplace_back(0, 0, 0);
    constexpr std::uint32_t kSlivers = 10'000;
    for (std::uint32_t i = 0; i < kSlivers; ++i) {
        const double angle = 2 * std::numbers::pi * i / kSlivers;
        fan.vertices.emplace_back(std::cos(angle), std::sin(angle), 0.1);
        fan.triangles.push_back({0, i + 1, (i + 1) % kSlivers + 1});
    }
    const mesh::TriangleMesh coarse = mesh::decimate(with_faces(fan), {.max_triangles = 500});
    EXPECT_LE(coarse.triangles.size(), 500u);
    expect_sound(coarse);
    EXPECT_NEAR(mesh::measure(coarse).surface_area, mesh::measure(fan).surface_area, 0.01);
}

TEST(ClusterVertices, NeverLeavesMoreThanAskedFor) {
    for (const std::size_t bound : {0u, 1u, 7u, 50u, 999u}) {
        const mesh::TriangleMesh coarse = mesh::cluster_vertices(torus_mesh(50, 40), bound);
        EXPECT_LE(coarse.triangles.size(), bound);
        EXPECT_GE(coarse.triangles.size(), bound >= 500 ? bound / 2 : 0);
        for (const auto& triangle : coarse.triangles) {
            for (const auto vertex : triangle) ASSERT_LT(vertex, coarse.vertices.size());
        }
    }
}

TEST(ClusterVertices, TakesMeshesWithoutExtent) {
    EXPECT_TRUE(mesh::cluster_vertices(mesh::TriangleMesh{}, 10).empty());
    mesh::TriangleMesh point;
    point.vertices.assign(3, Vec3(1, 2, 3));
    point.triangles = {{0, 1, 2}};
    EXPECT_TRUE(mesh::cluster_vertices(point, 0).empty());
}

TEST(Decimate, ReachesTheBoundOnBenchmarkModels) {
    OSSUARY_REQUIRE_BENCHMARK_DATA(data);
    for (const char* name :
         {"princeton-segmentation/off/61.off", "princeton-segmentation/off/305.off",
          "princeton-shape-train/off/m1544.off"}) {
        const auto read = mesh::read_mesh(data / name);
        ASSERT_TRUE(read) << read.error().message;
        const mesh::TriangleMesh coarse = mesh::decimate(read->mesh);
        EXPECT_LE(coarse.triangles.size(), 2000u) << name;
        EXPECT_GE(coarse.triangles.size(), 1000u) << name;
        expect_sound(coarse);
        EXPECT_NEAR(mesh::measure(coarse).diagonal, mesh::measure(read->mesh).diagonal,
                    0.05 * mesh::measure(read->mesh).diagonal);
    }
}

}  // namespace
}  // namespace ossuary::test
