#include "engine/voxel/volume_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <random>

#include "engine/mesh/inspect.h"
#include "engine/mesh/measures.h"
#include "engine/voxel/npy.h"
#include "engine/voxel/read_model.h"
#include "engine/voxel/voxelize.h"
#include "tests/support/packed.h"
#include "tests/support/shapes.h"

namespace ossuary::test {
namespace {

/// A volume of floats by a function of the voxel; `bytes` holds its values.
template <typename Value>
voxel::Volume float_volume(const Vec3i& size, std::string& bytes, const Value& value_at) {
    voxel::Volume volume;
    volume.size = size;
    volume.type = voxel::VoxelType::kFloat32;
    volume.order = std::endian::native;
    bytes.clear();
    for (int z = 0; z < size.z(); ++z) {
        for (int y = 0; y < size.y(); ++y) {
            for (int x = 0; x < size.x(); ++x) {
                const auto value = static_cast<float>(value_at(Vec3(x, y, z)));
                char raw[sizeof(float)];
                std::memcpy(raw, &value, sizeof(float));
                bytes.append(raw, sizeof(float));
            }
        }
    }
    volume.values = bytes;
    return volume;
}

/// 1000 in the middle of a ball, less by 10 a voxel.
double ball_value(const Vec3& at, const Vec3& middle) { return 1000 - 10 * (at - middle).norm(); }

double ball_volume(double radius) { return 4.0 / 3 * std::numbers::pi * std::pow(radius, 3); }

const mesh::MeshWarning* find(const voxel::VolumeSurface& surface, const std::string& code) {
    for (const mesh::MeshWarning& warning : surface.warnings) {
        if (warning.code == code) return &warning;
    }
    return nullptr;
}

TEST(VolumeSurface, FollowsThresholdAndSpacing) {
    std::string bytes;
    voxel::Volume volume = float_volume(
        {40, 40, 40}, bytes, [](const Vec3& at) { return ball_value(at, Vec3(19.5, 19.5, 19.5)); });
    volume.axes = Vec3(1, 2, 0.5).asDiagonal();
    volume.origin = Vec3(100, 0, 0);
    voxel::VolumeSurfaceOptions options;
    for (const double radius : {8.0, 15.0}) {
        options.inside.threshold = 1000 - 10 * radius;
        const auto surface = voxel::volume_surface(volume, options);
        ASSERT_TRUE(surface);
        const mesh::MeshMeasures measures = mesh::measure(surface->mesh);
        EXPECT_NEAR(measures.signed_volume / ball_volume(radius), 1.0, 0.03);
        EXPECT_LT((measures.bounds.center() - Vec3(119.5, 39, 9.75)).norm(), 1e-3);
        EXPECT_EQ(find(*surface, "volume_inside"), nullptr);
    }
}

TEST(VolumeSurface, ClosesWhatTheVolumeCutsOff) {
    std::string bytes;
    const voxel::Volume volume =
        float_volume({20, 20, 20}, bytes, [](const Vec3& at) { return at.x() < 10 ? 1 : 0; });
    const auto surface = voxel::volume_surface(volume);
    ASSERT_TRUE(surface);
    EXPECT_TRUE(mesh::inspect(surface->mesh).closed);
    EXPECT_NEAR(mesh::measure(surface->mesh).signed_volume, 10 * 20 * 20, 60);
}

TEST(VolumeSurface, TakesOneLabelOrAllOfThem) {
    std::string bytes;
    const voxel::Volume volume = float_volume({30, 12, 12}, bytes, [](const Vec3& at) {
        if ((at.array() < 2).any() || at.y() > 9 || at.z() > 9) return 0;
        return at.x() < 10 ? 1 : (at.x() < 20 ? 2 : (at.x() < 28 ? 7 : 0));
    });
    const auto all = voxel::volume_surface(volume);
    ASSERT_TRUE(all);
    EXPECT_NEAR(mesh::measure(all->mesh).signed_volume, 26 * 8 * 8, 80);
    ASSERT_NE(find(*all, "volume_inside"), nullptr);
    voxel::VolumeSurfaceOptions options;
    options.inside.label = 2;
    const auto one = voxel::volume_surface(volume, options);
    ASSERT_TRUE(one);
    EXPECT_NEAR(mesh::measure(one->mesh).signed_volume, 10 * 8 * 8, 50);
    options.inside.label = 3;
    EXPECT_EQ(voxel::volume_surface(volume, options).error().code, ErrorCode::kSolidEmpty);
    options.inside.label = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(voxel::volume_surface(volume, options).error().code, ErrorCode::kInvalidArgument);
}

TEST(VolumeSurface, PartsGreyValuesInTwo) {
    std::string bytes;
    std::mt19937 random(1);
    std::normal_distribution<double> noise(0.0, 8.0);
    const voxel::Volume volume = float_volume({32, 32, 32}, bytes, [&](const Vec3& at) {
        return ((at - Vec3(15.5, 15.5, 15.5)).norm() < 10 ? 150 : 60) + noise(random);
    });
    const auto surface = voxel::volume_surface(volume);
    ASSERT_TRUE(surface);
    EXPECT_NEAR(mesh::measure(surface->mesh).signed_volume / ball_volume(10), 1.0, 0.05);
    ASSERT_NE(find(*surface, "volume_inside"), nullptr);
}

TEST(VolumeSurface, CoarsensWhatIsTooFine) {
    std::string bytes;
    const voxel::Volume volume = float_volume(
        {61, 60, 59}, bytes, [](const Vec3& at) { return ball_value(at, Vec3(30, 30, 30)); });
    voxel::VolumeSurfaceOptions options;
    options.inside.threshold = 750;
    options.max_side = 31;
    const auto surface = voxel::volume_surface(volume, options);
    ASSERT_TRUE(surface);
    ASSERT_NE(find(*surface, "volume_coarsened"), nullptr);
    EXPECT_EQ(find(*surface, "volume_coarsened")->count, 2U);
    const mesh::MeshMeasures measures = mesh::measure(surface->mesh);
    EXPECT_NEAR(measures.signed_volume / ball_volume(25), 1.0, 0.03);
    EXPECT_LT((measures.bounds.center() - Vec3(30, 30, 30)).norm(), 0.2);
    options.max_side = 256;
    options.max_triangles = 6000;
    const auto fewer = voxel::volume_surface(volume, options);
    ASSERT_TRUE(fewer);
    EXPECT_LE(fewer->mesh.triangles.size(), 6000U);
    EXPECT_NEAR(mesh::measure(fewer->mesh).signed_volume / ball_volume(25), 1.0, 0.05);
}

TEST(VolumeSurface, CountsWhatIsNotFinite) {
    std::string bytes;
    const voxel::Volume volume = float_volume({10, 10, 10}, bytes, [](const Vec3& at) {
        if (at.x() < 1) return std::numeric_limits<double>::quiet_NaN();
        if (at.x() > 8) return -std::numeric_limits<double>::infinity();
        return at.x() + 0.5 * at.y();
    });
    voxel::VolumeSurfaceOptions options;
    options.inside.threshold = 1.0;
    const auto surface = voxel::volume_surface(volume, options);
    ASSERT_TRUE(surface);
    ASSERT_NE(find(*surface, "not_finite_voxels"), nullptr);
    EXPECT_EQ(find(*surface, "not_finite_voxels")->count, 200U);
    EXPECT_NEAR(mesh::measure(surface->mesh).bounds.sizes().x(), 8, 1.01);
    std::string nothing;
    const voxel::Volume none = float_volume(
        {3, 3, 3}, nothing, [](const Vec3&) { return std::numeric_limits<double>::quiet_NaN(); });
    EXPECT_EQ(voxel::volume_surface(none).error().code, ErrorCode::kSolidEmpty);
}

TEST(VolumeSurface, GivesBuiltSolidsBackWithTheirTopology) {
    for (const VolumeShape& shape : volume_shapes()) {
        const auto read = voxel::read_model(voxel::format_npy(shape.volume), shape.name);
        ASSERT_TRUE(read) << read.error().message;
        const auto solid = voxel::voxelize(
            read->mesh, {.resolution = 128, .fill_cavities = false, .close_small_tunnels = false});
        ASSERT_TRUE(solid) << shape.name;
        EXPECT_EQ(voxel::betti_numbers(solid->volume).components, shape.betti.components)
            << shape.name;
        EXPECT_EQ(voxel::betti_numbers(solid->volume).tunnels, shape.betti.tunnels) << shape.name;
    }
}

TEST(VolumeSurface, IsReadFromPackedFilesToo) {
    const std::string npy = voxel::format_npy(capsule_tree().volume);
    const auto plain = voxel::read_model(npy, "tree.npy");
    const auto packed = voxel::read_model(gzipped(npy), "tree.npy.gz");
    ASSERT_TRUE(plain && packed);
    EXPECT_EQ(plain->mesh.vertices, packed->mesh.vertices);
    EXPECT_EQ(plain->mesh.triangles, packed->mesh.triangles);
    const auto twice = voxel::read_model(gzipped(gzipped(npy)), "tree.npy.gz.gz");
    EXPECT_EQ(twice.error().code, ErrorCode::kFormatUnknown);
}

TEST(VolumeSurface, RefusesVolumesOfNoUsableScale) {
    std::string bytes;
    voxel::Volume volume =
        float_volume({4, 4, 4}, bytes, [](const Vec3& at) { return at.x() > 1 ? 1 : 0; });
    const std::string nrrd =
        "NRRD0001\ntype: uchar\ndimension: 3\nsizes: 2 1 1\nspacings: 1e35 1e35 1e35\n"
        "encoding: ascii\n\n0 1\n";
    const auto huge = voxel::read_model(nrrd, "huge.nrrd");
    ASSERT_FALSE(huge);
    EXPECT_EQ(huge.error().code, ErrorCode::kMeshScale);
    EXPECT_EQ(huge.error().message.rfind("huge.nrrd: ", 0), 0U);
}

TEST(VolumeSurface, StopsWhenAsked) {
    std::stop_source source;
    source.request_stop();
    std::string bytes;
    const voxel::Volume volume =
        float_volume({4, 4, 4}, bytes, [](const Vec3& at) { return at.x() > 1 ? 1 : 0; });
    EXPECT_EQ(voxel::volume_surface(volume, {}, source.get_token()).error().code,
              ErrorCode::kCancelled);
}

}  // namespace
}  // namespace ossuary::test
