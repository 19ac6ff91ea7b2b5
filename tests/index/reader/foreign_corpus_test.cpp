// The corpora of the formats that the reader process reads: every file a test of its own.

#include <gtest/gtest.h>

#include <random>

#include "index/model_reader.h"
#include "tests/engine/mesh/model_corpus.h"

namespace ossuary::test {
namespace {

std::vector<std::string> formats() {
    std::vector<std::string> formats = {"3mf", "gltf", "glb", "dae", "amf", "x3d", "fbx"};
    if (OSSUARY_READS_CAD) formats.insert(formats.end(), {"step", "iges"});
    return formats;
}

class ForeignCorpus : public testing::TestWithParam<FormatCase> {
protected:
    index::ModelReader reader_;
};

class ForeignCorpusGood : public ForeignCorpus {};

TEST_P(ForeignCorpusGood, IsReadAsExpected) {
    const ModelCase& expected = GetParam().model;
    const auto read = reader_.read({expected.bytes, expected.name, {}});
    expect_read(read, expected);
    ASSERT_TRUE(read);
    EXPECT_GT(read->metres_per_unit, 0.0);
    EXPECT_TRUE(read->up);
}

TEST_P(ForeignCorpusGood, GivesACodedErrorOrAMeshWhereItIsCutOrDamaged) {
    const std::string& bytes = GetParam().model.bytes;
    std::mt19937_64 random(11);
    for (int round = 0; round < 40; ++round) {
        std::string damaged = bytes;
        if (round % 2 == 0) {
            damaged.resize(random() % bytes.size());
        } else {
            for (std::size_t i = 0; i < 1 + random() % 4; ++i) {
                damaged[random() % damaged.size()] = static_cast<char>(random() % 256);
            }
        }
        const auto read = reader_.read({damaged, "damaged", {}});
        if (read) {
            for (const auto& triangle : read->mesh.triangles) {
                for (const std::uint32_t vertex : triangle) {
                    ASSERT_LT(vertex, read->mesh.vertices.size());
                }
            }
        } else {
            ASSERT_FALSE(read.error().message.empty());
            ASSERT_NE(read.error().code, ErrorCode::kInternal) << read.error().message;
            ASSERT_NE(read.error().code, ErrorCode::kReaderUnavailable) << read.error().message;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Corpus, ForeignCorpusGood,
                         testing::ValuesIn(format_cases(formats(), "ok")), case_name);

class ForeignCorpusBad : public ForeignCorpus {};

TEST_P(ForeignCorpusBad, IsRefusedAsExpected) {
    const ModelCase& expected = GetParam().model;
    expect_refused(reader_.read({expected.bytes, "folder/model", {}}), expected, "folder/model");
}

INSTANTIATE_TEST_SUITE_P(Corpus, ForeignCorpusBad,
                         testing::ValuesIn(format_cases(formats(), "bad")), case_name);

}  // namespace
}  // namespace ossuary::test
