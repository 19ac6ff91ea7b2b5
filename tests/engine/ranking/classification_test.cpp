#include "engine/ranking/classification.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/benchmark_data.h"

namespace ossuary::ranking {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr std::string_view kHierarchy =
    "PSB 1\n"
    "4 5\n"
    "\n"
    "aircraft 0 0\n"
    "airplane aircraft 2\n"
    "1118\n"
    "1120\n"
    "\n"
    "F117 airplane 1\n"
    "1298\n"
    "chair 0 2\n"
    "7\n"
    "my-chair.off\n";

TEST(Classification, ReadsAHierarchyInTheOrderOfTheFile) {
    const auto parsed = parse_classification(kHierarchy, "test.cla");
    ASSERT_TRUE(parsed.ok()) << parsed.error().message;
    ASSERT_EQ(parsed->classes.size(), 4U);
    EXPECT_EQ(parsed->classes[0].parent, "");
    EXPECT_EQ(parsed->classes[2].parent, "airplane");
    EXPECT_THAT(parsed->classes[1].models, ElementsAre("1118", "1120"));
    EXPECT_EQ(parsed->model_count(), 5U);
    EXPECT_EQ(full_class_name(*parsed, "F117"), "aircraft/airplane/F117");
    EXPECT_EQ(full_class_name(*parsed, "chair"), "chair");

    const auto models = models_in_order(*parsed);
    ASSERT_EQ(models.size(), 5U);
    EXPECT_EQ(models[0].id, "1118");
    EXPECT_EQ(models[0].class_name, "airplane");
    EXPECT_EQ(models[2].class_name, "F117");
    EXPECT_EQ(models[4].id, "my-chair.off");
}

TEST(Classification, NamesTheFilesThatAnIdMayStandFor) {
    EXPECT_THAT(candidate_file_names("12"), ElementsAre("12.off", "m12.off", "12.stl", "m12.stl",
                                                        "12.obj", "m12.obj", "12.ply", "m12.ply"));
    EXPECT_THAT(candidate_file_names("my-chair.off"), ElementsAre("my-chair.off"));
    EXPECT_THAT(candidate_file_names("my-chair.ply"), ElementsAre("my-chair.ply"));
}

TEST(Classification, SkipsAByteOrderMarkAndCarriageReturns) {
    std::string text = "\xEF\xBB\xBF" + std::string(kHierarchy);
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) {
        text.insert(at, 1, '\r');
    }
    const auto parsed = parse_classification(text, "test.cla");
    ASSERT_TRUE(parsed.ok()) << parsed.error().message;
    EXPECT_EQ(parsed->classes[3].models[1], "my-chair.off");
}

struct BadFile {
    const char* name;
    const char* text;
    const char* message;
};

class BadClassification : public ::testing::TestWithParam<BadFile> {};

TEST_P(BadClassification, IsRefusedWithItsLine) {
    const auto parsed = parse_classification(GetParam().text, "bad.cla");
    ASSERT_FALSE(parsed.ok());
    EXPECT_EQ(parsed.error().code, ErrorCode::kClaInvalid);
    EXPECT_THAT(parsed.error().message, HasSubstr(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    Corpus, BadClassification,
    ::testing::Values(
        BadFile{"empty", "", "line 1: empty file"}, BadFile{"blank", "\n\n \n", "empty file"},
        BadFile{"magic", "OFF\n1 1\n", "line 1: found 'OFF'; expected 'PSB 1'"},
        BadFile{"version", "PSB 2\n0 0\n", "line 1: found 'PSB 2'"},
        BadFile{"no_counts", "PSB 1\n", "expected the numbers of classes and models"},
        BadFile{"words_for_counts", "PSB 1\none two\n", "line 2: found 'one two'"},
        BadFile{"negative_counts", "PSB 1\n-1 0\n", "line 2: found '-1 0'"},
        BadFile{"short_class", "PSB 1\n1 1\nchair 1\n7\n", "line 3: found 'chair 1'"},
        BadFile{"bad_count", "PSB 1\n1 1\nchair 0 x\n7\n", "line 3: class 'chair' has 'x' models"},
        BadFile{"huge_count", "PSB 1\n1 1\nchair 0 99999999999\n7\n", "line 3: class 'chair'"},
        BadFile{"large_count", "PSB 1\n1 4294967295\nchair 0 4294967295\n7\n",
                "file ends; expected model 2 of 4294967295"},
        BadFile{"top_class", "PSB 1\n1 0\n0 0 0\n", "line 3: a class is named '0'"},
        BadFile{"unknown_parent", "PSB 1\n1 0\nF117 airplane 0\n", "line 3: class 'F117'"},
        BadFile{"own_parent", "PSB 1\n1 0\na a 0\n", "has the parent 'a'"},
        BadFile{"class_twice", "PSB 1\n2 0\na 0 0\na 0 0\n", "line 4: class 'a' stands on line 3"},
        BadFile{"model_twice", "PSB 1\n2 2\na 0 1\n7\nb 0 1\n7\n",
                "line 6: model '7' stands on line 4"},
        BadFile{"too_few_models", "PSB 1\n2 3\na 0 2\n1\nb 0 1\n2\n",
                "line 5: found 'b 0 1'; expected model 2 of 2 of class 'a'"},
        BadFile{"ends_early", "PSB 1\n1 2\na 0 2\n1\n", "file ends; expected model 2 of 2"},
        BadFile{"too_many_models", "PSB 1\n1 1\na 0 1\n1\n2\n", "line 5: found '2'"},
        BadFile{"total_models", "PSB 1\n1 3\na 0 1\n1\n",
                "1 classes and 1 models; the header says"},
        BadFile{"total_classes", "PSB 1\n2 1\na 0 1\n1\n", "the header says 2 and 1"},
        BadFile{"binary",
                "\x7F"
                "ELF\x01\x02\n",
                "line 1: found '?ELF"}),
    [](const auto& instance) { return std::string(instance.param.name); });

TEST(Classification, NamesAMissingFile) {
    const auto missing = read_classification("/nonexistent/some.cla");
    ASSERT_FALSE(missing.ok());
    EXPECT_EQ(missing.error().code, ErrorCode::kFileNotFound);
    EXPECT_THAT(missing.error().message, HasSubstr("some.cla"));
}

TEST(Classification, RefusesAFolder) {
    const auto folder = read_classification(::testing::TempDir());
    ASSERT_FALSE(folder.ok());
    EXPECT_EQ(folder.error().code, ErrorCode::kFileUnreadable);
}

TEST(Classification, ReadsAFile) {
    const std::filesystem::path path =
        std::filesystem::path(::testing::TempDir()) / "ossuary-classification-test.cla";
    std::ofstream(path) << kHierarchy;
    const auto read = read_classification(path);
    std::filesystem::remove(path);
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_EQ(read->model_count(), 5U);
}

TEST(Classification, ReadsTheBenchmarksOwnFiles) {
    OSSUARY_REQUIRE_BENCHMARK_DATA(data);
    const auto all = read_classification(data / "princeton-segmentation/segmentation-all.cla");
    ASSERT_TRUE(all.ok()) << all.error().message;
    EXPECT_EQ(all->classes.size(), 19U);
    EXPECT_EQ(all->model_count(), 380U);
    for (const ClassifiedModel& model : models_in_order(*all)) {
        const auto file = candidate_file_names(model.id).front();
        EXPECT_TRUE(std::filesystem::exists(data / "princeton-segmentation/off" / file)) << file;
    }
    const auto train = read_classification(data / "princeton-shape-train/train.cla");
    ASSERT_TRUE(train.ok()) << train.error().message;
    EXPECT_EQ(train->classes.size(), 129U);
    EXPECT_EQ(train->model_count(), 907U);
    EXPECT_EQ(full_class_name(*train, "barren"), "plant/tree/barren");
}

}  // namespace
}  // namespace ossuary::ranking
