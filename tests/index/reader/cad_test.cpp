// STEP and IGES files, written by OpenCASCADE.

#include <gtest/gtest.h>

#include <numbers>

#include "engine/mesh/components.h"
#include "engine/mesh/edge_table.h"
#include "engine/mesh/measures.h"
#include "engine/mesh/model_objects.h"
#include "engine/mesh/recognise_format.h"
#include "index/model_reader.h"
#include "tests/support/source_folder.h"

namespace ossuary::index {
namespace {

std::filesystem::path cad_file(const std::string& file) {
    return test::source_folder() / "tests/corpus" / file;
}

TEST(CadFiles, AreToldByTheirContents) {
    using mesh::ModelFormat;
    using mesh::recognise_format;
    EXPECT_EQ(recognise_format("ISO-10303-21;\nHEADER;"), ModelFormat::kStep);
    EXPECT_EQ(recognise_format(" \r\n/* by hand */ ISO-10303-21;\nHEADER;"), ModelFormat::kStep);
    const std::string start = "A box" + std::string(67, ' ') + "S      1";
    for (const char* end : {"\n", "\r\n"}) {
        EXPECT_EQ(recognise_format(start + end + "1H,,1H;,"), ModelFormat::kIges);
    }
    std::string zeros = start + "\n1H,";
    zeros.replace(73, 7, "0000001");
    EXPECT_EQ(recognise_format(zeros), ModelFormat::kIges);
    std::string second = start + "\n1H,";
    second[79] = '2';
    EXPECT_NE(recognise_format(second), ModelFormat::kIges);
    EXPECT_NE(recognise_format(start), ModelFormat::kIges);
}

#if OSSUARY_READS_CAD

mesh::ReadMeshResult read_cad_file(const std::string& file) {
    ModelReader reader;
    auto result = reader.read(cad_file(file));
    EXPECT_TRUE(result) << result.error().message;
    return result ? *std::move(result) : mesh::ReadMeshResult{};
}

TEST(CadFiles, AreCutIntoTrianglesAsFinelyAsIsSaid) {
    for (const char* file : {"step/solids/cylinder.step", "iges/solids/cylinder_in_inches.iges"}) {
        SCOPED_TRACE(file);
        const auto model = read_cad_file(file);
        const mesh::MeshMeasures measures = mesh::measure(model.mesh);
        EXPECT_NEAR(measures.bounds.sizes().z(), 20.0, 1e-6);
        // A regular polygon of sides that lie no further from the circle than is allowed.
        const double diagonal = std::sqrt(10.0 * 10.0 * 2 + 20.0 * 20.0);
        const double least = 5.0 - 1e-3 * diagonal;
        EXPECT_GT(measures.signed_volume, std::numbers::pi * least * least * 20.0);
        EXPECT_LE(measures.signed_volume, std::numbers::pi * 25.0 * 20.0);
        EXPECT_LT(model.mesh.triangles.size(), 1000u);
        EXPECT_EQ(mesh::connected_components(model.mesh).count, 1u);
        EXPECT_TRUE(model.warnings.empty());
        EXPECT_EQ(model.metres_per_unit, 1e-3);
    }
}

TEST(CadFiles, KeepTheirSolidsApartAndNamed) {
    const auto step = read_cad_file("step/solids/two_solids.step");
    EXPECT_EQ(mesh::object_names(step.objects), (std::vector<std::string>{"Plate", "Knob"}));
    for (const auto& model : {step, read_cad_file("iges/solids/two_solids.iges")}) {
        ASSERT_EQ(model.objects.size(), 2u);
        const auto first = mesh::measure(mesh::object_mesh(model.mesh, model.objects[0]));
        const auto second = mesh::measure(mesh::object_mesh(model.mesh, model.objects[1]));
        EXPECT_NEAR(first.signed_volume, 6000.0, 1e-6);
        EXPECT_NEAR(first.bounds.min().x(), 1.0, 1e-6);
        EXPECT_NEAR(second.bounds.center().x(), 100.0, 0.2);
        EXPECT_GT(second.signed_volume, 0.98 * std::numbers::pi * 25.0 * 20.0);
    }
}

TEST(CadFiles, PlaceASolidThatIsThereTwice) {
    const auto model = read_cad_file("step/solids/one_solid_twice.step");
    ASSERT_EQ(model.objects.size(), 2u);
    const auto second = mesh::measure(mesh::object_mesh(model.mesh, model.objects[1]));
    const auto both = mesh::measure(model.mesh);
    EXPECT_NEAR(both.bounds.sizes().x(), 110.0, 0.2);
    EXPECT_NEAR(second.signed_volume * 2, both.signed_volume, 1e-6 * both.signed_volume);
}

TEST(CadFiles, EndNoProcessWhereManyAreReadOneAfterTheOther) {
    ModelReader reader;
    for (int i = 0; i < 5; ++i) {
        for (const char* file : {"step/ok/box.step", "iges/ok/box.iges", "step/bad/cut_off.step"}) {
            const auto result = reader.read(cad_file(file));
            if (std::string_view(file).find("bad") == std::string_view::npos) {
                EXPECT_TRUE(result) << result.error().message;
            } else {
                EXPECT_EQ(result.error().code, ErrorCode::kSceneInvalid);
            }
        }
    }
}

#else

TEST(CadFiles, AreRefusedByNameWithoutOpenCascade) {
    ModelReader reader;
    const auto result = reader.read(cad_file("step/ok/box.step"));
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::kFormatUnsupported);
    EXPECT_NE(result.error().message.find("OpenCASCADE"), std::string::npos);
}

#endif

}  // namespace
}  // namespace ossuary::index
