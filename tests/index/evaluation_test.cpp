#include "index/evaluation.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "index/build_and_pose.h"
#include "index/pose_gallery.h"
#include "index/presentation.h"
#include "tests/index/small_collection.h"

namespace ossuary::index {
namespace {

namespace fs = std::filesystem;

using CollectionEvaluation = SmallCollection;

TEST_F(CollectionEvaluation, EvaluatesASampleWhichIsTheSameEachTime) {
    Searcher searcher = open();
    const auto snapshot = *searcher.snapshot();
    const auto whole = *evaluate(*snapshot, searcher.stores());
    EvaluateOptions options;
    options.sample = 4;
    const auto some = evaluate(*snapshot, searcher.stores(), options);
    ASSERT_TRUE(some) << some.error().message;
    EXPECT_EQ(some->queries, 9U);
    ASSERT_EQ(some->report.per_query.size(), 4U);
    EXPECT_EQ(some->distances.size, 0U);
    const auto again = *evaluate(*snapshot, searcher.stores(), options);
    for (std::size_t i = 0; i < 4; ++i) {
        const ranking::QueryMetrics& query = some->report.per_query[i];
        EXPECT_EQ(again.report.per_query[i].model, query.model);
        // Each searches in the whole collection, as in an evaluation of all.
        EXPECT_NEAR(query.metrics.dcg, whole.report.per_query[query.model].metrics.dcg, 1e-9);
    }
    for (const std::size_t enough : {9U, 10U}) {
        options.sample = enough;
        EXPECT_EQ(evaluate(*snapshot, searcher.stores(), options)->distances.size, 9U);
    }
}

TEST_F(CollectionEvaluation, EvaluatesTheClassesOfTheIndex) {
    Searcher searcher = open();
    const auto snapshot = *searcher.snapshot();
    const auto evaluation = evaluate(*snapshot, searcher.stores());
    ASSERT_TRUE(evaluation) << evaluation.error().message;
    EXPECT_EQ(evaluation->report.models, 9U);
    EXPECT_EQ(evaluation->report.classes, 3U);
    EXPECT_GT(evaluation->report.mean.nearest_neighbor, 0.6);
    EXPECT_EQ(evaluation->distances.size, 9U);
    for (std::size_t i = 0; i < 9; ++i) {
        EXPECT_EQ(evaluation->order[i], static_cast<ModelId>(i + 1));
    }
    const nlohmann::json json = to_json(*evaluation);
    EXPECT_EQ(json["per_class"]["torus"]["models"], 3);
    EXPECT_EQ(json["precision_recall"].size(), 20U);
    EXPECT_EQ(json["confusion"]["values"].size(), 3U);
}

TEST_F(CollectionEvaluation, EvaluatesJustTheModelsOfAClassificationInItsOrder) {
    const fs::path copy = folder_->path() / "named.index";
    fs::copy_file(index(), copy, fs::copy_options::overwrite_existing);
    auto store = Store::open(copy, Access::kReadWrite);
    std::vector<Change> moves;
    for (ModelId id = 1; id <= 9; ++id) {
        const std::string name = (id % 2 == 0 ? "m" : "") + std::to_string(id);
        moves.push_back(MoveModel{id, "/m/" + name + ".off", name, std::nullopt});
    }
    ASSERT_TRUE(store->apply(moves));
    StorePool stores(*store);
    const auto snapshot = *Snapshot::load(*store);
    EvaluateOptions options;
    options.rank.ranker = ranking::RankerKind::kSkeleton;
    options.classification = *ranking::parse_classification(
        "PSB 1\n2 6\nring 0 3\n6\n3\n99\nbox 0 3\n7\n1\n4\n", "x.cla");
    const auto evaluation = evaluate(*snapshot, stores, options);
    ASSERT_TRUE(evaluation) << evaluation.error().message;
    EXPECT_EQ(evaluation->order, (std::vector<ModelId>{6, 3, 7, 1, 4}));
    EXPECT_EQ(evaluation->labels, (std::vector<std::string>{"ring", "ring", "box", "box", "box"}));
    EXPECT_EQ(evaluation->missing, (std::vector<std::string>{"99"}));
    EXPECT_EQ(evaluation->report.models, 5U);

    options.classification =
        *ranking::parse_classification("PSB 1\n1 2\nx 0 2\n500\n501\n", "x.cla");
    EXPECT_EQ(evaluate(*snapshot, stores, options).error().code, ErrorCode::kClaUnknownModel);
    options.classification =
        *ranking::parse_classification("PSB 1\n2 2\nx 0 1\n1\ny 0 1\n2\n", "x.cla");
    EXPECT_EQ(evaluate(*snapshot, stores, options).error().code, ErrorCode::kInvalidArgument);
}

TEST_F(CollectionEvaluation, ShowsModelsBesideTheNearestOfTheirClassByBuildAndByPose) {
    Searcher searcher = open();
    const auto snapshot = *searcher.snapshot();
    const auto evaluation = *evaluate(*snapshot, searcher.stores());
    const auto examples = *pose_examples(*snapshot, searcher.stores(), evaluation, 2);
    ASSERT_EQ(examples.size(), 6U);
    for (const PoseExample& example : examples) {
        for (const ModelId other : {example.by_build, example.by_pose}) {
            EXPECT_NE(other, example.model);
            EXPECT_EQ(searcher.store().model(other)->class_name, example.class_name);
        }
    }
    const auto html = pose_gallery_html(searcher.store(), examples);
    ASSERT_TRUE(html) << html.error().message;
    std::size_t pictures = 0;
    for (std::size_t at = html->find("<img"); at != std::string::npos;
         at = html->find("<img", at + 1)) {
        ++pictures;
        // A PNG's first bytes, so that the text is its bytes.
        EXPECT_NE(html->find("base64,iVBORw0KGgo", at), std::string::npos);
    }
    EXPECT_EQ(pictures, 18U);
    const fs::path out = folder_->path() / "report";
    ASSERT_TRUE(write_pose_gallery(out, searcher.store(), examples));
    EXPECT_EQ(test::read_file(out / "poses.html"), *html);
}

TEST_F(CollectionEvaluation, MeasuresBuildAndPoseAtSeveralWeights) {
    const fs::path copy = folder_->path() / "builds.index";
    fs::copy_file(index(), copy, fs::copy_options::overwrite_existing);
    auto store = Store::open(copy, Access::kReadWrite);
    std::vector<Change> moves;
    for (ModelId id = 1; id <= 9; ++id) {
        const std::string name = std::to_string(id);
        moves.push_back(MoveModel{id, "/m/" + name + ".off", name, std::nullopt});
    }
    ASSERT_TRUE(store->apply(moves));
    StorePool stores(*store);
    const auto snapshot = *Snapshot::load(*store);
    BuildAndPoseOptions options;
    options.rank.pose = 0.4;
    options.build = *ranking::parse_classification(
        "PSB 1\n3 9\nx 0 3\n1\n4\n7\ny 0 3\n2\n5\n8\nz 0 3\n3\n6\n99\n", "b.cla");
    options.pose =
        *ranking::parse_classification("PSB 1\n2 4\nup 0 2\n1\n2\ndown 0 2\n4\n5\n", "p.cla");
    const auto measured = evaluate_build_and_pose(*snapshot, stores, options);
    ASSERT_TRUE(measured) << measured.error().message;
    EXPECT_EQ(measured->models, 8U);
    EXPECT_EQ(measured->builds, 3U);
    EXPECT_EQ(measured->poses, 2U);
    EXPECT_EQ(measured->missing, (std::vector<std::string>{"99"}));
    ASSERT_EQ(measured->curve.size(), 9U);
    EXPECT_EQ(measured->curve.front().weight, 0.0);
    EXPECT_EQ(measured->curve.back().weight, 1.0);
    for (const BuildAndPose::Point& point : measured->curve) {
        EXPECT_EQ(point.build.all.queries, 8U);
        EXPECT_EQ(point.pose.all.queries, 4U);
        // Each pose is there once for each of two bodies.
        EXPECT_EQ(point.pose.others.queries, 4U);
    }
    const nlohmann::json json = to_json(*measured);
    EXPECT_EQ(json["curve"][5]["weight"], 0.4);
    EXPECT_TRUE(json["curve"][0]["build"]["among_other_poses"].contains("first_tier"));
    EXPECT_TRUE(json["curve"][0]["pose"]["among_other_builds"].contains("nearest_neighbor"));
    const std::string csv = build_and_pose_csv({&*measured, 1});
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 4 * 9);
    EXPECT_NE(build_and_pose_svg({&*measured, 1}).find("<polyline"), std::string::npos);

    options.rank.ranker = ranking::RankerKind::kChainCode;
    EXPECT_EQ(evaluate_build_and_pose(*snapshot, stores, options)->curve.size(), 1U);
    options.pose = *ranking::parse_classification("PSB 1\n1 1\nx 0 1\n500\n", "p.cla");
    EXPECT_EQ(evaluate_build_and_pose(*snapshot, stores, options).error().code,
              ErrorCode::kClaUnknownModel);
}

TEST_F(CollectionEvaluation, KeepsEvaluationsUntilTheIndexChanges) {
    const fs::path copy = folder_->path() / "cached.index";
    fs::copy_file(index(), copy, fs::copy_options::overwrite_existing);
    auto store = Store::open(copy, Access::kReadWrite);
    StorePool stores(*store);
    const auto snapshot = *Snapshot::load(*store);
    const auto first = evaluate_cached(*store, *snapshot, stores);
    ASSERT_TRUE(first);
    EXPECT_EQ(first->distances.size, 9U);
    const auto second = evaluate_cached(*store, *snapshot, stores);
    ASSERT_TRUE(second);
    EXPECT_EQ(second->distances.size, 0U) << "from the cache";
    // The store says when it kept an evaluation, to the second.
    auto kept = to_json(*second);
    kept["computed_at"] = to_json(*first)["computed_at"];
    EXPECT_EQ(to_json(*first), kept);
    EvaluateOptions reranked;
    reranked.rank.rerank = true;
    EXPECT_EQ(evaluate_cached(*store, *snapshot, stores, reranked)->distances.size, 9U);
    ASSERT_TRUE(store->remove(9));
    const auto later = *Snapshot::load(*store);
    EXPECT_EQ(evaluate_cached(*store, *later, stores)->distances.size, 8U);

    auto reader = Store::open(copy, Access::kReadOnly);
    reranked.rank.pose = 0.5;
    EXPECT_TRUE(evaluate_cached(*reader, *later, stores, reranked)) << "though it cannot be kept";
}

}  // namespace
}  // namespace ossuary::index
