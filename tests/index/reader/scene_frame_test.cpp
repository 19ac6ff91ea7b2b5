#include "index/reader/scene_frame.h"

#include <gtest/gtest.h>

#include "index/model_reader.h"
#include "tests/support/source_folder.h"

namespace ossuary::index {
namespace {

TEST(SceneFrame, IsThatOfTheFile) {
    ModelReader reader;
    struct Case {
        const char* file;
        double metres;
        mesh::UpAxis up;
    };
    for (const Case& each : {Case{"dae/ok/tetrahedron.dae", 1.0, mesh::UpAxis::kY},
                             Case{"dae/ok/inches_and_z_up.dae", 0.0254, mesh::UpAxis::kZ},
                             Case{"dae/ok/without_unit_and_axis.dae", 1.0, mesh::UpAxis::kY},
                             Case{"amf/ok/in_inches.amf", 0.0254, mesh::UpAxis::kZ},
                             Case{"amf/ok/without_unit.amf", 1e-3, mesh::UpAxis::kZ},
                             Case{"x3d/ok/tetrahedron.x3d", 1.0, mesh::UpAxis::kY},
                             Case{"fbx/ok/text.fbx", 0.0254, mesh::UpAxis::kZ}}) {
        const auto read = reader.read(test::source_folder() / "tests/corpus" / each.file);
        ASSERT_TRUE(read) << each.file << read.error().message;
        EXPECT_NEAR(read->metres_per_unit, each.metres, 1e-9) << each.file;
        EXPECT_EQ(read->up, each.up) << each.file;
        // Nothing is turned or scaled: the corner furthest along each axis is at 1.
        for (int axis = 0; axis < 3; ++axis) {
            double most = 0.0;
            for (const Vec3& vertex : read->mesh.vertices) most = std::max(most, vertex[axis]);
            EXPECT_NEAR(most, 1.0, 1e-6) << each.file;
        }
    }
}

TEST(SceneFrame, TakesOddUnitsAsIfNoneWereSaid) {
    for (const char* unit : {"", "-1", "0", "nan", "inf", "wide", "1e999"}) {
        const std::string text =
            std::string("<COLLADA><asset><unit meter=\"") + unit + "\"/></asset></COLLADA>";
        EXPECT_EQ(collada_frame(text).metres_per_unit, 1.0) << unit;
    }
    EXPECT_EQ(collada_frame("<COLLADA><up_axis>X_UP</up_axis>").up, mesh::UpAxis::kX);
    EXPECT_EQ(amf_frame("<amf unit=\"league\">").metres_per_unit, 1e-3);
    EXPECT_EQ(amf_frame("<!-- <amf -->").metres_per_unit, 1e-3);
}

}  // namespace
}  // namespace ossuary::index
