#include "index/segmentation_evaluation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "engine/decomposition/seg_file.h"
#include "engine/mesh/write_mesh.h"
#include "tests/index/sample_index.h"
#include "tests/support/shapes.h"

namespace ossuary::index {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& path, const std::string& text) {
    fs::create_directories(path.parent_path());
    std::ofstream(path) << text;
}

/// Models 1 and 2 are boxes of 12 triangles; two people see two halves, one sees one part.
class SegmentationEvaluationTest : public ::testing::Test {
protected:
    SegmentationEvaluationTest() {
        options_.models = folder_.path() / "off";
        options_.truth = folder_.path() / "seg";
        options_.segmentations = folder_.path() / "ours";
        options_.jobs = 1;
        for (const std::string id : {"1", "2"}) {
            write(options_.models / (id + ".off"),
                  mesh::to_off(test::box_mesh({0, 0, 0}, {1, 1, 1})));
            write(options_.truth / id / (id + "_0.seg"), halves());
            write(options_.truth / id / (id + "_1.seg"), halves());
            write(options_.truth / id / (id + "_2.seg"), whole());
        }
        write(options_.segmentations / "1.seg", halves());
        write(options_.segmentations / "2.seg", whole());
    }
    static std::string halves() { return "0\n0\n0\n0\n0\n0\n1\n1\n1\n1\n1\n1\n"; }
    static std::string whole() { return "0\n0\n0\n0\n0\n0\n0\n0\n0\n0\n0\n0\n"; }

    test::TemporaryFolder folder_;
    SegmentationEvaluationOptions options_;
};

TEST_F(SegmentationEvaluationTest, AveragesOverPeopleThenModels) {
    const auto evaluation = evaluate_segmentation(options_);
    ASSERT_TRUE(evaluation.ok()) << evaluation.error().message;
    ASSERT_EQ(evaluation->models.size(), 2u);
    EXPECT_TRUE(evaluation->failures.empty());
    const double differing = 36.0 / 66.0;  // pairs across the halves
    EXPECT_NEAR(evaluation->models[0].scores.rand_index_error, differing / 3, 1e-12);
    EXPECT_NEAR(evaluation->models[1].scores.rand_index_error, differing * 2 / 3, 1e-12);
    EXPECT_NEAR(evaluation->mean.scores.rand_index_error, differing / 2, 1e-12);
    EXPECT_NEAR(evaluation->mean.scores.people_rand_index_error, differing * 2 / 3, 1e-12);
    EXPECT_EQ(evaluation->mean.scores.people_parts, 2.0);
    // The cut of model 1 is that of two people; against the third it is not defined.
    EXPECT_EQ(evaluation->models[0].scores.cut_discrepancy, 0.0);
    // It is additional to the third; whoever makes no cut makes none too many.
    const double length = evaluation->models[0].scores.registered_cuts * 3 * std::sqrt(6.0);
    EXPECT_NEAR(length, evaluation->models[1].scores.missing_cuts * 1.5 * std::sqrt(6.0), 1e-12);
    EXPECT_GT(length, 3.9);
    EXPECT_EQ(evaluation->models[1].scores.registered_cuts, 0.0);
    EXPECT_EQ(evaluation->models[0].scores.missing_cuts, 0.0);
}

TEST_F(SegmentationEvaluationTest, GivesTheMeansOfEachClass) {
    options_.classification =
        *ranking::parse_classification("PSB 1\n2 2\n\na 0 1\n2\n\nb 0 1\n1\n", "x.cla");
    const auto evaluation = evaluate_segmentation(options_);
    ASSERT_TRUE(evaluation.ok()) << evaluation.error().message;
    ASSERT_EQ(evaluation->per_class.size(), 2u);
    EXPECT_EQ(evaluation->per_class[0].name, "a");
    EXPECT_NEAR(evaluation->per_class[0].scores.rand_index_error, 24.0 / 66.0, 1e-12);
    const nlohmann::json json = to_json(*evaluation);
    for (const char* field : {"models", "rand_index_error", "hamming", "cut_discrepancy",
                              "consistency_error", "per_class"}) {
        EXPECT_TRUE(json.contains(field)) << field;
    }
    EXPECT_EQ(json["per_class"][1]["class"], "b");
}

TEST_F(SegmentationEvaluationTest, SegmentsWhereNoSegmentationsAreGiven) {
    options_.segmentations.clear();
    options_.parts_of_people = true;
    const auto evaluation = evaluate_segmentation(options_);
    ASSERT_TRUE(evaluation.ok()) << evaluation.error().message;
    for (const auto& model : evaluation->models) {
        EXPECT_EQ(model.segmentation.labels.size(), 12u);
        EXPECT_EQ(model.segmentation.parts, 2u);
        EXPECT_GT(model.took_ms, 0.0);
    }
}

TEST_F(SegmentationEvaluationTest, LeavesOutWhatFails) {
    write(options_.segmentations / "2.seg", "0\n1\n");
    const auto evaluation = evaluate_segmentation(options_);
    ASSERT_TRUE(evaluation.ok()) << evaluation.error().message;
    EXPECT_EQ(evaluation->models.size(), 1u);
    ASSERT_EQ(evaluation->failures.size(), 1u);
    EXPECT_EQ(evaluation->failures[0].id, "2");
    EXPECT_EQ(evaluation->failures[0].error.code, ErrorCode::kSegInvalid);
}

TEST_F(SegmentationEvaluationTest, SaysThatThereIsNothingToEvaluate) {
    options_.truth = folder_.path() / "nowhere";
    EXPECT_EQ(evaluate_segmentation(options_).error().code, ErrorCode::kFileNotFound);
    options_.truth = options_.models;
    EXPECT_EQ(evaluate_segmentation(options_).error().code, ErrorCode::kModelNotFound);
}

}  // namespace
}  // namespace ossuary::index
