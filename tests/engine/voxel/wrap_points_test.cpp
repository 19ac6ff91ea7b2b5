#include "engine/voxel/wrap_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "engine/mesh/inspect.h"
#include "engine/mesh/measures.h"
#include "engine/mesh/sample_surface.h"
#include "tests/support/shapes.h"

namespace ossuary::test {
namespace {

std::vector<Vec3> points_of(const mesh::TriangleMesh& mesh, std::size_t count, double noise = 0) {
    mesh::SampleSurfaceOptions options;
    options.count = count;
    options.stratified = false;
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal(0.0, noise * mesh::measure(mesh).diagonal);
    std::vector<Vec3> points;
    for (const mesh::SurfaceSample& sample : mesh::sample_surface(mesh, options)) {
        points.push_back(sample.point);
        if (noise > 0) points.back() += Vec3(normal(random), normal(random), normal(random));
    }
    return points;
}

TEST(WrapPoints, GivesTheSolidBack) {
    for (const MeshShape& shape : mesh_shapes()) {
        const auto wrapped = voxel::wrap_points(points_of(shape.mesh, 5000, 0.002));
        ASSERT_TRUE(wrapped) << shape.name << ": " << wrapped.error().message;
        const mesh::MeshReport report = mesh::inspect(wrapped->mesh);
        EXPECT_TRUE(report.closed && report.oriented) << shape.name;
        EXPECT_EQ(report.components, 1U) << shape.name;
        EXPECT_EQ(report.genus, shape.betti.tunnels) << shape.name;
    }
}

TEST(WrapPoints, KeepsVolumeAndPlace) {
    const mesh::TriangleMesh box = box_mesh({10, 20, 30}, {12, 23, 35});
    const auto wrapped = voxel::wrap_points(points_of(box, 5000));
    ASSERT_TRUE(wrapped);
    const mesh::MeshMeasures measures = mesh::measure(wrapped->mesh);
    EXPECT_NEAR(measures.signed_volume, 30.0, 1.5);
    EXPECT_LT((measures.bounds.center() - Vec3(11, 21.5, 32.5)).norm(), 0.05);
    EXPECT_GT(wrapped->spacing, 0.01);
    EXPECT_LT(wrapped->spacing, 0.1);
}

TEST(WrapPoints, TakesSetsOfAnySize) {
    const mesh::TriangleMesh sphere = icosphere_mesh(Vec3::Zero(), 1.0, 4);
    for (const std::size_t count : {60UL, 300UL, 2000UL, 200'000UL}) {
        const auto wrapped = voxel::wrap_points(points_of(sphere, count));
        ASSERT_TRUE(wrapped) << count;
        const double volume = mesh::measure(wrapped->mesh).signed_volume;
        EXPECT_GT(volume, count < 100 ? 2.0 : 3.7) << count;
        EXPECT_LT(volume, count < 1000 ? 5.5 : 4.7) << count;
    }
}

TEST(WrapPoints, ScalesWithThePoints) {
    std::vector<Vec3> points = points_of(torus_mesh(3, 1), 3000);
    const auto plain = voxel::wrap_points(points);
    for (Vec3& point : points) point *= 1024;
    const auto scaled = voxel::wrap_points(points);
    ASSERT_TRUE(plain && scaled);
    ASSERT_EQ(plain->mesh.triangles, scaled->mesh.triangles);
    for (std::size_t i = 0; i < plain->mesh.vertices.size(); ++i) {
        ASSERT_EQ(1024 * plain->mesh.vertices[i], scaled->mesh.vertices[i]);
    }
    EXPECT_EQ(1024 * plain->radius, scaled->radius);
}

TEST(WrapPoints, DoesNotDependOnTheOrder) {
    std::vector<Vec3> points = points_of(capsule_tree_mesh(), 3000);
    const auto plain = voxel::wrap_points(points);
    std::mt19937 random(5);
    std::shuffle(points.begin(), points.end(), random);
    const auto shuffled = voxel::wrap_points(points);
    ASSERT_TRUE(plain && shuffled);
    EXPECT_EQ(plain->mesh.vertices, shuffled->mesh.vertices);
    EXPECT_EQ(plain->mesh.triangles, shuffled->mesh.triangles);
}

TEST(WrapPoints, GivesPointsOfASheetSomeThickness) {
    std::vector<Vec3> points;
    for (int x = 0; x < 60; ++x) {
        for (int y = 0; y < 60; ++y) points.emplace_back(x, y, 0);
    }
    const auto wrapped = voxel::wrap_points(points);
    ASSERT_TRUE(wrapped);
    const mesh::MeshMeasures measures = mesh::measure(wrapped->mesh);
    EXPECT_GT(measures.signed_volume, 59 * 59 * 0.05);
    EXPECT_LT(measures.bounds.sizes().z(), 2.0);
}

TEST(WrapPoints, LeavesStrayPointsOut) {
    std::vector<Vec3> points = points_of(icosphere_mesh(Vec3::Zero(), 1.0, 4), 4000);
    points.emplace_back(3, 0, 0);
    points.emplace_back(0, -2.5, 0);
    const auto wrapped = voxel::wrap_points(points);
    ASSERT_TRUE(wrapped);
    EXPECT_EQ(wrapped->stray_points, 2U);
    EXPECT_LT(mesh::measure(wrapped->mesh).diagonal, 4.0);
}

TEST(WrapPoints, RefusesTooFewAndThoseInOnePlace) {
    EXPECT_EQ(voxel::wrap_points({}).error().code, ErrorCode::kPointsTooFew);
    const std::vector<Vec3> few = points_of(icosphere_mesh(Vec3::Zero(), 1.0, 3), 49);
    EXPECT_EQ(voxel::wrap_points(few).error().code, ErrorCode::kPointsTooFew);
    const std::vector<Vec3> same(1000, Vec3(1, 2, 3));
    EXPECT_EQ(voxel::wrap_points(same).error().code, ErrorCode::kMeshNoExtent);
    std::vector<Vec3> two(1000, Vec3(1, 2, 3));
    two.front() = Vec3(4, 5, 6);
    EXPECT_EQ(voxel::wrap_points(two).error().code, ErrorCode::kPointsTooFew);
}

TEST(WrapPoints, StopsWhenAsked) {
    std::stop_source source;
    source.request_stop();
    const auto wrapped = voxel::wrap_points(points_of(icosphere_mesh(Vec3::Zero(), 1.0, 3), 500),
                                            {}, source.get_token());
    EXPECT_EQ(wrapped.error().code, ErrorCode::kCancelled);
}

}  // namespace
}  // namespace ossuary::test
