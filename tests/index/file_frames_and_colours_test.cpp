// What an index keeps of a file's unit, axes and colours, and what it makes of them.

#include <gtest/gtest.h>

#include "engine/mesh/read_mesh.h"
#include "engine/mesh/write_mesh.h"
#include "index/codec.h"
#include "index/describe_model.h"
#include "index/presentation.h"
#include "index/preview.h"
#include "index/unit.h"
#include "tests/index/same_bits.h"
#include "tests/index/sample_index.h"
#include "tests/support/shapes.h"
#include "tests/support/source_folder.h"

namespace ossuary::index {
namespace {

using Of = PreviewColours::Of;

mesh::TriangleMesh coloured(mesh::TriangleMesh mesh, const mesh::CornerColours& colours) {
    mesh.corner_colours.assign(mesh.triangles.size(), colours);
    return mesh;
}

constexpr mesh::Colour kRed = {255, 0, 0}, kGreen = {0, 255, 0}, kBlue = {0, 0, 255};

NewModel describe(const std::string& bytes, ModelReader* reader = nullptr) {
    auto model = describe_model({bytes, "model", {}, reader}, test::kCoarse);
    EXPECT_TRUE(model) << model.error().message;
    return model ? *std::move(model) : NewModel{};
}

std::string corpus(const std::string& file) {
    return test::read_file(test::source_folder() / "tests" / "corpus" / file);
}

TEST(UnitNames, AreTheUsualOnesOrALength) {
    EXPECT_EQ(unit_name(1e-3), "mm");
    EXPECT_EQ(unit_name(0.0254), "inch");
    EXPECT_EQ(unit_name(2.54 * 0.01), "inch");
    EXPECT_EQ(unit_name(double{0.0254F}), "inch");
    EXPECT_EQ(unit_name(1.0), "m");
    EXPECT_EQ(unit_name(0.3), "0.3 m");
    EXPECT_EQ(unit_name(0.0), "");
}

TEST(ColouredModels, AreDescribedLikePlainOnes) {
    const mesh::TriangleMesh plain = test::capsule_tree_mesh();
    const NewModel model = describe(mesh::to_ply(plain));
    const NewModel painted = describe(mesh::to_ply(coloured(plain, {kRed, kRed, kRed})));
    test::expect_same_bits(painted.descriptor, model.descriptor);
    EXPECT_EQ(encode_skeleton(painted.skeleton), encode_skeleton(model.skeleton));
    EXPECT_EQ(painted.preview.positions, model.preview.positions);
    EXPECT_EQ(painted.preview.triangles, model.preview.triangles);
    ASSERT_TRUE(painted.segments && model.segments);
    EXPECT_EQ(encode_segments(*painted.segments), encode_segments(*model.segments));
    EXPECT_NE(painted.thumbnail, model.thumbnail);
    EXPECT_EQ(model.preview.colours, PreviewColours{});
    EXPECT_EQ(painted.preview.colours, (PreviewColours{Of::kModel, {255, 0, 0}}));
}

TEST(PreviewColours, TakeTheSmallestFormAndComeBackTheSame) {
    mesh::TriangleMesh square;
    square.vertices = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)};
    square.triangles = {{0, 1, 2}, {0, 2, 3}};
    square.face_of_triangle = {0, 1};
    square.face_count = 2;
    const auto form = [&](const std::vector<mesh::CornerColours>& colours) {
        square.corner_colours = colours;
        const PreviewMesh preview = make_preview(square);
        EXPECT_EQ(mesh_of(preview).corner_colours, colours);
        return preview.colours.of;
    };
    EXPECT_EQ(form({}), Of::kNothing);
    EXPECT_EQ(form({{kRed, kRed, kRed}, {kRed, kRed, kRed}}), Of::kModel);
    EXPECT_EQ(form({{kRed, kGreen, kBlue}, {kRed, kBlue, kGreen}}), Of::kVertices);
    EXPECT_EQ(form({{kRed, kRed, kRed}, {kBlue, kBlue, kBlue}}), Of::kTriangles);
    EXPECT_EQ(form({{kRed, kGreen, kBlue}, {kBlue, kBlue, kGreen}}), Of::kCorners);
}

TEST(FileFrames, AreKeptAndShown) {
    ModelReader reader;
    const NewModel inches = describe(corpus("3mf/ok/in_inches.3mf"), &reader);
    EXPECT_EQ(inches.summary.frame, (FileFrame{0.0254, Up::kZ}));
    EXPECT_EQ(inches.summary.orientation, (Orientation{Up::kZ, false}));
    nlohmann::json json = to_json(inches.summary);
    EXPECT_EQ(json["unit"], "inch");
    EXPECT_EQ(json["metres_per_unit"], 0.0254);
    EXPECT_EQ(json["up"], "z");
    EXPECT_EQ(json["up_from"], "file");
    const NewModel sideways = describe(corpus("dae/ok/x_up.dae"), &reader);
    EXPECT_EQ(sideways.summary.frame.up, Up::kX);
    EXPECT_EQ(sideways.summary.orientation, (Orientation{Up::kX, false}));
    json = to_json(describe(mesh::to_off(test::capsule_tree_mesh())).summary);
    EXPECT_TRUE(json["unit"].is_null());
    EXPECT_TRUE(json["metres_per_unit"].is_null());
    EXPECT_EQ(json["up_from"], "shape");
    json = to_json(describe(corpus("gltf/ok/colours_of_materials.gltf"), &reader).preview, Box3());
    EXPECT_EQ(json["colours"]["of"], "triangles");
    EXPECT_EQ(json["colours"]["values"].size(), 12U);
}

}  // namespace
}  // namespace ossuary::index
