// The corpora of the formats that the reader process reads: every file a test of its own.

#include <gtest/gtest.h>

#include <random>

#include "engine/mesh/measures.h"
#include "index/model_reader.h"
#include "tests/engine/mesh/model_corpus.h"

namespace ossuary::test {
namespace {

struct ForeignCase {
    std::string format;
    ModelCase model;
};

void PrintTo(const ForeignCase& foreign_case, std::ostream* out) {
    *out << foreign_case.format << "/" << foreign_case.model.name;
}

std::vector<ForeignCase> foreign_cases(const std::string& folder) {
    std::vector<ForeignCase> cases;
    for (const std::string format : {"3mf", "gltf", "glb", "dae", "amf", "x3d", "fbx"}) {
        for (ModelCase& model : model_cases(format, folder)) {
            cases.push_back({format, std::move(model)});
        }
    }
    return cases;
}

std::string case_name(const testing::TestParamInfo<ForeignCase>& info) {
    return info.param.format + "_" + info.param.model.name;
}

class ForeignCorpus : public testing::TestWithParam<ForeignCase> {
protected:
    index::ModelReader reader_;
};

class ForeignCorpusGood : public ForeignCorpus {};

TEST_P(ForeignCorpusGood, IsReadAsExpected) {
    const ModelCase& expected = GetParam().model;
    const auto read = reader_.read({expected.bytes, expected.name, {}});
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->mesh.vertices.size(), expected.vertices);
    EXPECT_EQ(read->mesh.face_count, expected.faces);
    EXPECT_EQ(read->mesh.triangles.size(), expected.triangles);
    EXPECT_EQ(counted(read->warnings), expected.warnings);
    const mesh::MeshMeasures measures = mesh::measure(read->mesh);
    if (expected.area) {
        EXPECT_NEAR(measures.surface_area, *expected.area, 1e-6);
    }
    EXPECT_GT(read->metres_per_unit, 0.0);
    ASSERT_TRUE(read->up);
    if (expected.metres_per_unit) {
        EXPECT_NEAR(read->metres_per_unit, *expected.metres_per_unit, 1e-9);
    }
    if (expected.up) {
        EXPECT_EQ("xyz"[static_cast<int>(*read->up)], *expected.up);
    }
    if (expected.colours) {
        EXPECT_EQ(colours_text(read->mesh), *expected.colours);
    }
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

INSTANTIATE_TEST_SUITE_P(Corpus, ForeignCorpusGood, testing::ValuesIn(foreign_cases("ok")),
                         case_name);

class ForeignCorpusBad : public ForeignCorpus {};

TEST_P(ForeignCorpusBad, IsRefusedAsExpected) {
    const ModelCase& expected = GetParam().model;
    const auto read = reader_.read({expected.bytes, "folder/model", {}});
    ASSERT_FALSE(read);
    const std::string& message = read.error().message;
    EXPECT_EQ(to_string(read.error().code), expected.code) << message;
    for (const std::string& part : expected.says) {
        EXPECT_NE(message.find(part), std::string::npos) << message;
    }
    EXPECT_NE(message.find("expected"), std::string::npos) << message;
    EXPECT_EQ(message.rfind("folder/model", 0), 0u) << message;
}

INSTANTIATE_TEST_SUITE_P(Corpus, ForeignCorpusBad, testing::ValuesIn(foreign_cases("bad")),
                         case_name);

}  // namespace
}  // namespace ossuary::test
