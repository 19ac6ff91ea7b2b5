#include "tests/engine/mesh/model_corpus.h"

#include <gtest/gtest.h>

#include "engine/mesh/measures.h"
#include "engine/mesh/read_mesh.h"
#include "engine/mesh/write_mesh.h"

namespace ossuary::test {
namespace {

class OffCorpusGood : public testing::TestWithParam<FormatCase> {};

TEST_P(OffCorpusGood, IsReadAsExpected) {
    const ModelCase& expected = GetParam().model;
    expect_read(mesh::read_mesh(expected.bytes, expected.name), expected);
}

TEST_P(OffCorpusGood, ComesBackTheSameAfterWriting) {
    const Result<mesh::ReadMeshResult> read = mesh::read_mesh(GetParam().model.bytes, "original");
    ASSERT_TRUE(read) << read.error().message;
    const Result<mesh::ReadMeshResult> again = mesh::read_mesh(mesh::to_off(read->mesh), "written");
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(again->mesh.triangles, read->mesh.triangles);
    EXPECT_EQ(again->mesh.vertices, read->mesh.vertices);
    EXPECT_EQ(again->mesh.corner_colours, read->mesh.corner_colours);
}

INSTANTIATE_TEST_SUITE_P(Corpus, OffCorpusGood, testing::ValuesIn(format_cases({"off"}, "ok")),
                         case_name);

class OffCorpusBad : public testing::TestWithParam<FormatCase> {};

TEST_P(OffCorpusBad, IsRefusedAsExpected) {
    const ModelCase& expected = GetParam().model;
    const Result<mesh::ReadMeshResult> read = mesh::read_mesh(expected.bytes, "folder/model.off");
    expect_refused(read, expected, "folder/model.off");
    if (!read) expect_line(read.error().message, expected);
}

INSTANTIATE_TEST_SUITE_P(Corpus, OffCorpusBad, testing::ValuesIn(format_cases({"off"}, "bad")),
                         case_name);

// ---- every good file once more, written differently ----

/// The text with each line end replaced.
std::string with_newlines(const std::string& text, const std::string& newline) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n') continue;
        if (text[i] == '\n' || text[i] == '\r') {
            result += newline;
        } else {
            result += text[i];
        }
    }
    return result;
}

TEST_P(OffCorpusGood, MeansTheSameWithOtherLineEndsAndComments) {
    const std::string& bytes = GetParam().model.bytes;
    if (bytes.find('\0') != std::string::npos) return;  // binary, and has no lines
    const Result<mesh::ReadMeshResult> read = mesh::read_mesh(bytes, "original");
    ASSERT_TRUE(read) << read.error().message;
    for (const std::string newline : {"\n", "\r\n", "\r", "\n\n", " \n", " # 1 2 3 OFF\n"}) {
        const Result<mesh::ReadMeshResult> other =
            mesh::read_mesh(with_newlines(bytes, newline), "variant");
        ASSERT_TRUE(other) << other.error().message;
        EXPECT_EQ(other->mesh.vertices, read->mesh.vertices);
        EXPECT_EQ(other->mesh.triangles, read->mesh.triangles);
        EXPECT_EQ(counted(other->warnings), counted(read->warnings));
    }
}

TEST_P(OffCorpusGood, KeepsItsAreaWhenRotatedAndDuplicated) {
    const Result<mesh::ReadMeshResult> read = mesh::read_mesh(GetParam().model.bytes, "original");
    ASSERT_TRUE(read) << read.error().message;
    mesh::TriangleMesh twice = read->mesh;
    const auto count = static_cast<std::uint32_t>(twice.vertices.size());
    const Mat3 rotation = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    for (std::uint32_t v = 0; v < count; ++v) {
        twice.vertices.push_back(rotation * twice.vertices[v]);
    }
    for (mesh::TriangleMesh::Triangle triangle : read->mesh.triangles) {
        for (std::uint32_t& vertex : triangle) vertex += count;
        twice.triangles.push_back(triangle);
    }
    const auto& colours = read->mesh.corner_colours;
    twice.corner_colours.insert(twice.corner_colours.end(), colours.begin(), colours.end());
    const Result<mesh::ReadMeshResult> again = mesh::read_mesh(mesh::to_off(twice), "twice");
    // A rotated diagonal may leave the range of coordinates that are taken.
    if (!again && again.error().code == ErrorCode::kOffNonFinite) return;
    ASSERT_TRUE(again) << again.error().message;
    const mesh::MeshMeasures once = mesh::measure(read->mesh);
    if (read->mesh.empty()) return;
    // Far from the origin a coordinate's last digit is a length that counts.
    const double furthest =
        std::max(once.bounds.min().cwiseAbs().maxCoeff(), once.bounds.max().cwiseAbs().maxCoeff());
    const double rounding = 1e-14 * furthest * once.diagonal;
    EXPECT_NEAR(mesh::measure(again->mesh).surface_area, 2 * once.surface_area,
                1e-9 * once.surface_area + rounding);
}

}  // namespace
}  // namespace ossuary::test
