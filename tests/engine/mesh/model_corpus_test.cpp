// The corpora of STL, OBJ, PLY and XYZ files; that of OFF files has tests of its own beside these.

#include "tests/engine/mesh/model_corpus.h"

#include <gtest/gtest.h>

#include <random>

#include "engine/mesh/read_mesh.h"
#include "engine/mesh/write_mesh.h"

namespace ossuary::test {
namespace {

const std::vector<std::string> kFormats = {"stl", "obj", "ply", "xyz"};

class ModelCorpusGood : public testing::TestWithParam<FormatCase> {};

TEST_P(ModelCorpusGood, IsReadAsExpected) {
    const ModelCase& expected = GetParam().model;
    const auto read = mesh::read_mesh(expected.bytes, expected.name);
    expect_read(read, expected);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->metres_per_unit, 0.0);
    EXPECT_FALSE(read->up);
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

INSTANTIATE_TEST_SUITE_P(Corpus, ModelCorpusGood, testing::ValuesIn(format_cases(kFormats, "ok")),
                         case_name);

class ModelCorpusBad : public testing::TestWithParam<FormatCase> {};

TEST_P(ModelCorpusBad, IsRefusedAsExpected) {
    const ModelCase& expected = GetParam().model;
    const auto read = mesh::read_mesh(expected.bytes, "folder/model");
    expect_refused(read, expected, "folder/model");
    if (!read) expect_line(read.error().message, expected);
}

INSTANTIATE_TEST_SUITE_P(Corpus, ModelCorpusBad, testing::ValuesIn(format_cases(kFormats, "bad")),
                         case_name);

}  // namespace
}  // namespace ossuary::test
