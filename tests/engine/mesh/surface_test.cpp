#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/mesh/geodesics.h"
#include "engine/mesh/measures.h"
#include "engine/mesh/sample_surface.h"
#include "engine/mesh/vertex_normals.h"
#include "tests/engine/mesh/built_meshes.h"

namespace ossuary::test {
namespace {

TEST(VertexNormals, PointOutwardsOnASphere) {
    const mesh::TriangleMesh sphere = sphere_mesh();
    const auto normals = mesh::vertex_normals(sphere);
    for (std::size_t v = 0; v < normals.size(); ++v) {
        EXPECT_NEAR(normals[v].norm(), 1.0, 1e-12);
        EXPECT_GT(normals[v].dot(sphere.vertices[v]), 0.995);
    }
}

TEST(VertexNormals, DoNotDependOnHowACubeIsCut) {
    const mesh::TriangleMesh cube = cube_mesh();
    const auto normals = mesh::vertex_normals(cube);
    for (std::size_t v = 0; v < 8; ++v) {
        EXPECT_TRUE(normals[v].isApprox((cube.vertices[v] - Vec3(.5, .5, .5)).normalized(), 1e-12));
    }
}

TEST(VertexNormals, WorkAtEveryScale) {
    for (const double scale : {1e-70, 1e70}) {
        const auto normals =
            mesh::vertex_normals(moved(sphere_mesh(1), Mat3::Identity(), scale, Vec3::Zero()));
        for (const Vec3& normal : normals) EXPECT_NEAR(normal.norm(), 1.0, 1e-12);
    }
}

TEST(VertexNormals, AreZeroWhereNothingHasArea) {
    mesh::TriangleMesh mesh = cube_mesh();
    mesh.vertices.emplace_back(7, 7, 7);
    mesh.triangles.push_back({8, 8, 8});
    EXPECT_EQ(mesh::vertex_normals(mesh)[8], Vec3::Zero());
    EXPECT_EQ(mesh::triangle_normals(mesh)[12], Vec3::Zero());
}

TEST(SampleSurface, SpreadsUniformlyOverTheArea) {
    for (const bool stratified : {true, false}) {
        mesh::SampleSurfaceOptions options;
        options.count = 20'000;
        options.stratified = stratified;
        // Triangles of very different size: a fine torus beside a big cube.
        const mesh::TriangleMesh cube = moved(cube_mesh(4), Mat3::Identity(), 1, Vec3(5, 0, 0));
        const mesh::TriangleMesh mesh = joined(torus_mesh(), cube);
        const auto samples = mesh::sample_surface(mesh, options);
        ASSERT_EQ(samples.size(), options.count);
        std::size_t on_cube = 0;
        Vec3 mean = Vec3::Zero();
        for (const mesh::SurfaceSample& sample : samples) {
            on_cube += sample.triangle >= torus_mesh().triangles.size() ? 1 : 0;
            mean += sample.point / double(samples.size());
            const auto [a, b, c] = mesh.corners(sample.triangle);
            EXPECT_NEAR((sample.point - a).dot((b - a).cross(c - a)), 0.0, 1e-9);
            EXPECT_NEAR(sample.barycentric.sum(), 1.0, 1e-12);
            EXPECT_GE(sample.barycentric.minCoeff(), 0.0);
            EXPECT_NEAR(sample.normal.norm(), 1.0, 1e-9);
        }
        const double share = mesh::measure(cube).surface_area / mesh::measure(mesh).surface_area;
        EXPECT_NEAR(double(on_cube) / double(samples.size()), share, 0.015);
        EXPECT_LT((mean - mesh::measure(mesh).area_centroid).norm(), 0.1);
    }
}

TEST(SampleSurface, CoversATriangleEvenly) {
    mesh::TriangleMesh mesh;
    mesh.vertices = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    mesh.triangles = {{0, 1, 2}};
    mesh::SampleSurfaceOptions options;
    options.count = 40'000;
    // Each quarter of the triangle, cut at the middles of its sides, gets a quarter.
    std::array<double, 4> quarter{};
    for (const mesh::SurfaceSample& sample : mesh::sample_surface(mesh, options)) {
        Eigen::Index largest = 0;
        const bool corner = sample.barycentric.maxCoeff(&largest) > 0.5;
        quarter[corner ? std::size_t(largest) : 3] += 1.0 / 40'000;
    }
    for (const double share : quarter) EXPECT_NEAR(share, 0.25, 0.01);
}

TEST(SampleSurface, DependsOnItsSeedOnly) {
    const mesh::TriangleMesh mesh = torus_mesh();
    mesh::SampleSurfaceOptions options;
    const auto a = mesh::sample_surface(mesh, options);
    const auto b = mesh::sample_surface(mesh, options);
    options.seed = 2;
    const auto c = mesh::sample_surface(mesh, options);
    std::size_t differing = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].point, b[i].point);
        differing += a[i].point != c[i].point ? 1 : 0;
    }
    EXPECT_EQ(differing, a.size());
}

TEST(SampleSurface, AvoidsDegenerateTrianglesAndEmptyMeshes) {
    mesh::TriangleMesh mesh = cube_mesh();
    mesh.triangles.insert(mesh.triangles.begin(), 5, {0, 0, 1});
    mesh.triangles.insert(mesh.triangles.end(), 5, {2, 2, 2});
    for (const auto& sample : mesh::sample_surface(with_faces(mesh))) {
        EXPECT_GE(sample.triangle, 5u);
        EXPECT_LT(sample.triangle, 17u);
    }
    EXPECT_TRUE(mesh::sample_surface(mesh::TriangleMesh{}).empty());
}

TEST(GeodesicGraph, MeasuresHalfACircleAroundASphere) {
    const mesh::TriangleMesh sphere = sphere_mesh(5);
    // Vertices 0 and 1 are opposite poles.
    const mesh::GeodesicGraph graph(sphere);
    const auto distances = graph.distances_from(0);
    EXPECT_GE(distances[1], 0.999 * std::numbers::pi);
    EXPECT_LE(distances[1], 1.03 * std::numbers::pi);
    for (std::size_t v = 0; v < distances.size(); ++v) {
        const double exact = std::acos(std::clamp(sphere.vertices[v].x(), -1.0, 1.0));
        EXPECT_GE(distances[v], 0.998 * exact);
        EXPECT_LE(distances[v], 1.1 * exact + 1e-12);
    }
}

TEST(GeodesicGraph, GoesStraightAcrossTrianglesToo) {
    mesh::GeodesicOptions edges_only;
    edges_only.cross_edges = false;
    const mesh::TriangleMesh square = square_mesh(16);
    const auto other_corner = std::uint32_t(16 * 17);  // against the diagonals of the cells
    const std::uint32_t corner = 16;
    const double with = mesh::GeodesicGraph(square).distances_from(corner)[other_corner];
    const double without =
        mesh::GeodesicGraph(square, edges_only).distances_from(corner)[other_corner];
    EXPECT_NEAR(with, std::sqrt(2.0), 1e-9);
    EXPECT_NEAR(without, 2.0, 1e-9);
}

TEST(GeodesicGraph, IsAMetricOnTheVertices) {
    const mesh::TriangleMesh mesh = renumbered(torus_mesh(12, 8), 5);
    const mesh::GeodesicGraph graph(mesh);
    std::vector<std::vector<double>> all;
    for (std::uint32_t v = 0; v < graph.vertex_count(); ++v) all.push_back(graph.distances_from(v));
    for (std::size_t a = 0; a < all.size(); ++a) {
        EXPECT_EQ(all[a][a], 0.0);
        for (std::size_t b = 0; b < all.size(); ++b) {
            EXPECT_NEAR(all[a][b], all[b][a], 1e-12);
            EXPECT_GE(all[a][b], (mesh.vertices[a] - mesh.vertices[b]).norm() - 1e-12);
            EXPECT_LE(all[a][b], all[a][7] + all[7][b] + 1e-12);
        }
    }
    const std::array<std::uint32_t, 2> sources = {3, 20};
    const auto both = graph.distances_from(sources);
    for (std::size_t v = 0; v < both.size(); ++v) {
        EXPECT_EQ(both[v], std::min(all[3][v], all[20][v]));
    }
}

TEST(GeodesicGraph, CannotReachOtherComponents) {
    const mesh::TriangleMesh mesh = joined(cube_mesh(), cube_mesh());
    const auto distances = mesh::GeodesicGraph(mesh).distances_from(0);
    for (std::size_t v = 0; v < 16; ++v) EXPECT_EQ(std::isfinite(distances[v]), v < 8);
}

}  // namespace
}  // namespace ossuary::test
