#include "engine/voxel/read_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "engine/mesh/measures.h"
#include "engine/mesh/sample_surface.h"
#include "engine/mesh/write_mesh.h"
#include "tests/support/shapes.h"

namespace ossuary::test {
namespace {

/// The coordinates of points of a ball's surface, a line each.
std::string ball_points(std::size_t count) {
    mesh::SampleSurfaceOptions options;
    options.count = count;
    std::ostringstream text;
    text.precision(17);
    for (const mesh::SurfaceSample& sample :
         mesh::sample_surface(icosphere_mesh(Vec3(5, 5, 5), 1.0, 4), options)) {
        text << sample.point.x() << ' ' << sample.point.y() << ' ' << sample.point.z() << '\n';
    }
    return text.str();
}

bool has_warning(const mesh::ReadMeshResult& read, const std::string& code) {
    return std::any_of(read.warnings.begin(), read.warnings.end(),
                       [&](const mesh::MeshWarning& warning) { return warning.code == code; });
}

TEST(ReadModel, WrapsPointsOfEveryFormatAlike) {
    const std::string lines = ball_points(2000);
    const auto xyz = voxel::read_model(lines, "points.xyz");
    ASSERT_TRUE(xyz) << xyz.error().message;
    EXPECT_NEAR(mesh::measure(xyz->mesh).signed_volume, 4.19, 0.4);
    EXPECT_TRUE(has_warning(*xyz, "points_wrapped"));
    EXPECT_FALSE(has_warning(*xyz, "no_triangles"));
    EXPECT_FALSE(has_warning(*xyz, "unreferenced_vertices"));
    std::string obj = lines;
    for (std::size_t at = 0; at < obj.size(); at = obj.find('\n', at) + 1) obj.insert(at, "v ");
    const std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 2000\nproperty double x\nproperty double y\n"
        "property double z\nend_header\n" +
        lines;
    for (const std::string& bytes : {ply, "OFF\n2000 0 0\n" + lines, "2000 0 0\n" + lines, obj}) {
        const auto read = voxel::read_model(bytes, "points");
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_EQ(read->mesh.vertices, xyz->mesh.vertices);
        EXPECT_EQ(read->mesh.triangles, xyz->mesh.triangles);
    }
}

TEST(ReadModel, LeavesMeshesAsTheyAre) {
    const mesh::TriangleMesh box = box_mesh({0, 0, 0}, {1, 2, 3});
    const auto read = voxel::read_model(mesh::to_off(box), "box");
    ASSERT_TRUE(read);
    EXPECT_EQ(read->mesh.vertices, box.vertices);
    EXPECT_EQ(read->mesh.triangles, box.triangles);
    // Lines are no points.
    const auto lines = voxel::read_model("OFF\n2 1 0\n0 0 0\n1 0 0\n2 0 1\n", "lines");
    ASSERT_TRUE(lines);
    EXPECT_TRUE(lines->mesh.empty());
    const auto nothing = voxel::read_model("OFF\n0 0 0\n", "nothing");
    ASSERT_TRUE(nothing);
    EXPECT_TRUE(nothing->mesh.empty());
}

TEST(ReadModel, NamesTheFileThatHasTooFewPoints) {
    const auto read = voxel::read_model("OFF\n2 0 0\n0 0 0\n1 0 0\n", "two.off");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, ErrorCode::kPointsTooFew);
    EXPECT_EQ(read.error().message.rfind("two.off: expected", 0), 0U) << read.error().message;
}

}  // namespace
}  // namespace ossuary::test
