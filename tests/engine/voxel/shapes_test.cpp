#include "tests/support/shapes.h"

#include <gtest/gtest.h>

#include <map>

namespace ossuary::test {
namespace {

TEST(BuiltVolumes, HaveTwoEmptyLayersOnEachSide) {
    for (const VolumeShape& shape : volume_shapes()) {
        Vec3i low = shape.volume.size(), high = Vec3i::Zero();
        voxel::for_each_voxel(shape.volume, [&](const Vec3i& v) {
            low = low.cwiseMin(v);
            high = high.cwiseMax(v);
        });
        EXPECT_GE(low.minCoeff(), 2) << shape.name;
        EXPECT_GE((shape.volume.size() - high).minCoeff(), 3) << shape.name;
    }
}

TEST(BuiltMeshes, AreClosedAndOrientedOutwards) {
    for (const MeshShape& shape : mesh_shapes()) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
        double volume = 0;
        for (std::size_t t = 0; t < shape.mesh.triangles.size(); ++t) {
            const auto& corner = shape.mesh.triangles[t];
            for (int i = 0; i < 3; ++i) {
                const auto a = corner[static_cast<std::size_t>(i)];
                const auto b = corner[static_cast<std::size_t>((i + 1) % 3)];
                balance[std::minmax(a, b)] += a < b ? 1 : -1;
            }
            const auto [a, b, c] = shape.mesh.corners(t);
            volume += a.dot(b.cross(c));
        }
        for (const auto& [edge, sum] : balance) ASSERT_EQ(sum, 0) << shape.name;
        EXPECT_GT(volume, 0) << shape.name;
        EXPECT_EQ(shape.mesh.face_of_triangle.size(), shape.mesh.triangles.size()) << shape.name;
    }
}

TEST(RandomRotation, IsARotation) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const Mat3 r = random_rotation(seed);
        EXPECT_NEAR((r * r.transpose() - Mat3::Identity()).norm(), 0, 1e-12);
        EXPECT_NEAR(r.determinant(), 1, 1e-12);
    }
}

}  // namespace
}  // namespace ossuary::test
