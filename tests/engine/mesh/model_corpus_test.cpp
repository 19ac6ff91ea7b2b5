// The corpora of STL, OBJ, PLY and XYZ files; that of OFF files has tests of its own beside these.

#include "tests/engine/mesh/model_corpus.h"

#include <gtest/gtest.h>

#include <random>

#include "engine/mesh/measures.h"
#include "engine/mesh/read_mesh.h"
#include "engine/mesh/write_mesh.h"

namespace ossuary::test {
namespace {

struct FormatCase {
    std::string format;
    ModelCase model;
};

void PrintTo(const FormatCase& format_case, std::ostream* out) {
    *out << format_case.format << "/" << format_case.model.name;
}

std::vector<FormatCase> format_cases(const std::string& folder) {
    std::vector<FormatCase> cases;
    for (const std::string format : {"stl", "obj", "ply", "xyz"}) {
        for (ModelCase& model : model_cases(format, folder)) {
            cases.push_back({format, std::move(model)});
        }
    }
    return cases;
}

std::string case_name(const testing::TestParamInfo<FormatCase>& info) {
    return info.param.format + "_" + info.param.model.name;
}

void expect_whole(const mesh::TriangleMesh& mesh) {
    ASSERT_EQ(mesh.face_of_triangle.size(), mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        ASSERT_LT(mesh.face_of_triangle[t], mesh.face_count);
        for (const std::uint32_t vertex : mesh.triangles[t]) {
            ASSERT_LT(vertex, mesh.vertices.size());
        }
    }
    for (const Vec3& vertex : mesh.vertices) ASSERT_TRUE(vertex.allFinite());
}

class ModelCorpusGood : public testing::TestWithParam<FormatCase> {};

TEST_P(ModelCorpusGood, IsReadAsExpected) {
    const ModelCase& expected = GetParam().model;
    const auto read = mesh::read_mesh(expected.bytes, expected.name);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->mesh.vertices.size(), expected.vertices);
    EXPECT_EQ(read->mesh.face_count, expected.faces);
    EXPECT_EQ(read->mesh.triangles.size(), expected.triangles);
    EXPECT_EQ(counted(read->warnings), expected.warnings);
    if (expected.colours) {
        EXPECT_EQ(colours_text(read->mesh), *expected.colours);
    }
    EXPECT_EQ(read->metres_per_unit, 0.0);
    EXPECT_FALSE(read->up);
    if (expected.area) {
        EXPECT_NEAR(mesh::measure(read->mesh).surface_area, *expected.area, 1e-6);
    }
    expect_whole(read->mesh);
}

TEST_P(ModelCorpusGood, ComesBackTheSameThroughOff) {
    const auto read = mesh::read_mesh(GetParam().model.bytes, "original");
    ASSERT_TRUE(read) << read.error().message;
    const auto again = mesh::read_mesh(mesh::to_off(read->mesh), "written");
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(again->mesh.vertices, read->mesh.vertices);
    EXPECT_EQ(again->mesh.triangles, read->mesh.triangles);
}

TEST_P(ModelCorpusGood, GivesACodedErrorOrAMeshForEveryTruncation) {
    const std::string& bytes = GetParam().model.bytes;
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        const auto read = mesh::read_mesh(bytes.substr(0, length), "cut");
        if (read) {
            ASSERT_LE(read->mesh.triangles.size(), GetParam().model.triangles);
            expect_whole(read->mesh);
        } else {
            ASSERT_FALSE(read.error().message.empty());
        }
    }
}

TEST_P(ModelCorpusGood, SurvivesRandomDamage) {
    std::mt19937_64 random(7);
    for (int round = 0; round < 300; ++round) {
        std::string bytes = GetParam().model.bytes;
        for (std::size_t i = 0; i < 1 + random() % 4 && !bytes.empty(); ++i) {
            const std::size_t at = random() % bytes.size();
            switch (random() % 4) {
                case 0:
                    bytes[at] = static_cast<char>(random() % 256);
                    break;
                case 1:
                    bytes.insert(at, 1, "0123456789-+.e/\\ \n\r"[random() % 19]);
                    break;
                case 2:
                    bytes.erase(at, 1 + random() % 5);
                    break;
                default:
                    bytes.insert(at, bytes.substr(random() % bytes.size(), random() % 20));
            }
        }
        const auto read = mesh::read_mesh(bytes, "damaged");
        if (read) expect_whole(read->mesh);
    }
}

INSTANTIATE_TEST_SUITE_P(Corpus, ModelCorpusGood, testing::ValuesIn(format_cases("ok")), case_name);

class ModelCorpusBad : public testing::TestWithParam<FormatCase> {};

TEST_P(ModelCorpusBad, IsRefusedAsExpected) {
    const ModelCase& expected = GetParam().model;
    const auto read = mesh::read_mesh(expected.bytes, "folder/model");
    ASSERT_FALSE(read);
    const std::string& message = read.error().message;
    EXPECT_EQ(to_string(read.error().code), expected.code) << message;
    for (const std::string& part : expected.says) {
        EXPECT_NE(message.find(part), std::string::npos) << message;
    }
    EXPECT_NE(message.find("expected"), std::string::npos) << message;
    EXPECT_EQ(message.rfind("folder/model", 0), 0u) << message;
    const std::string line = "line " + std::to_string(expected.line) + ":";
    EXPECT_EQ(message.find(line) != std::string::npos, expected.line > 0) << message;
    for (const char c : message) EXPECT_TRUE(c >= ' ' && c <= '~') << message;
}

INSTANTIATE_TEST_SUITE_P(Corpus, ModelCorpusBad, testing::ValuesIn(format_cases("bad")), case_name);

}  // namespace
}  // namespace ossuary::test
