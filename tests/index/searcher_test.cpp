#include "index/searcher.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

#include "engine/mesh/measures.h"
#include "engine/mesh/read_mesh.h"
#include "index/build_and_pose.h"
#include "index/codec.h"
#include "index/evaluation.h"
#include "index/indexer.h"
#include "index/missing_features.h"
#include "index/pose_gallery.h"
#include "index/presentation.h"
#include "tests/index/sample_index.h"
#include "tests/support/shapes.h"

namespace ossuary::index {
namespace {

namespace fs = std::filesystem;

/// One small collection for all tests of this file: boxes, trees and tori by turns.
class SearcherTest : public testing::Test {
protected:
    static void SetUpTestSuite() {
        folder_ = std::make_unique<test::TemporaryFolder>();
        test::write_sample_meshes(models(), 9);
        auto store = Store::create_or_open(index(), test::kCoarse);
        ASSERT_TRUE(store) << store.error().message;
        IndexOptions options;
        options.paths = {models()};
        ProgressSink quiet;
        ASSERT_TRUE(index_models(*store, options, quiet));
        for (ModelId id = 1; id <= 9; ++id) {
            const std::string name = store->model(id)->name;
            const std::vector<Change> change = {ClassifyModel{id, name.substr(3)}};
            ASSERT_TRUE(store->apply(change));
        }
    }
    static void TearDownTestSuite() { folder_.reset(); }
    static fs::path models() { return folder_->path() / "models"; }
    static fs::path index() { return folder_->path() / "x.index"; }

    Searcher open() {
        auto searcher = Searcher::open(index());
        EXPECT_TRUE(searcher) << searcher.error().message;
        return *std::move(searcher);
    }
    static mesh::TriangleMesh mesh(const std::string& name) {
        auto read = mesh::read_mesh(models() / name);
        EXPECT_TRUE(read);
        return std::move(read->mesh);
    }
    static std::string kind(const Hit& hit) { return hit.name.substr(3); }

    static std::unique_ptr<test::TemporaryFolder> folder_;
};

std::unique_ptr<test::TemporaryFolder> SearcherTest::folder_;

TEST_F(SearcherTest, FindsTheModelItselfFirstByEveryRanker) {
    Searcher searcher = open();
    for (const ranking::RankerKind ranker : ranking::kAllRankers) {
        SearchOptions options;
        options.rank.ranker = ranker;
        const auto result = searcher.search(mesh("04_tree.off"), options);
        ASSERT_TRUE(result) << result.error().message;
        ASSERT_EQ(result->hits.size(), 9U);
        EXPECT_EQ(result->hits[0].name, "04_tree") << to_string(ranker);
        for (std::size_t i = 0; i < result->hits.size(); ++i) {
            EXPECT_EQ(result->hits[i].rank, i + 1);
            if (i > 0) {
                EXPECT_GE(result->hits[i].distance, result->hits[i - 1].distance);
            }
        }
    }
}

TEST_F(SearcherTest, PutsModelsOfTheSameShapeFirst) {
    Searcher searcher = open();
    const auto result = searcher.search(mesh("05_torus.off"));
    ASSERT_TRUE(result);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(kind(result->hits[i]), "torus") << i;
}

TEST_F(SearcherTest, ExplainsItsHitsWithIndicesThatExist) {
    Searcher searcher = open();
    const auto result = searcher.search(mesh("01_tree.off"));
    ASSERT_TRUE(result);
    const skeleton::SkeletonGraph& query = result->query_skeleton.graph;
    EXPECT_EQ(result->query_skeleton.chain_codes.size(), query.branches.size());
    for (const Hit& hit : result->hits) {
        EXPECT_FALSE(hit.parts.empty());
        EXPECT_EQ(hit.matched_nodes, hit.match.nodes.size());
        const auto skeleton = searcher.store().skeleton(hit.id);
        for (const auto& pair : hit.match.nodes) {
            EXPECT_LT(pair.a, query.nodes.size());
            EXPECT_LT(pair.b, skeleton->graph.nodes.size());
        }
        for (const auto& pair : hit.match.branches) {
            EXPECT_LT(pair.a, query.branches.size());
            EXPECT_LT(pair.b, skeleton->graph.branches.size());
        }
    }
    EXPECT_GE(result->hits[0].matched_nodes, 4U) << "a tree against itself";
    std::vector<std::string> stages;
    for (const StageTime& time : result->stages_ms) stages.push_back(time.stage);
    for (const char* stage : {"voxelize", "thin", "refine", "rank", "explain"}) {
        EXPECT_NE(std::find(stages.begin(), stages.end(), stage), stages.end()) << stage;
    }
    EXPECT_GT(result->took_ms, 0.0);
}

TEST_F(SearcherTest, HeedsLimitAndClass) {
    Searcher searcher = open();
    SearchOptions options;
    options.limit = 2;
    SearchOptions unlimited;
    unlimited.limit = 0;
    const auto all = searcher.search(mesh("00_box.off"), unlimited);
    EXPECT_EQ(searcher.search(mesh("00_box.off"), options)->hits.size(), 2U);
    options.limit = 10;
    options.class_filter = "tree";
    options.with_match = false;
    const auto trees = searcher.search(mesh("00_box.off"), options);
    ASSERT_EQ(trees->hits.size(), 3U);
    for (const Hit& hit : trees->hits) {
        EXPECT_EQ(hit.class_name, "tree");
        EXPECT_TRUE(hit.parts.empty());
        for (const Hit& other : all->hits) {
            if (other.id == hit.id) {
                EXPECT_EQ(other.distance, hit.distance) << "as without";
            }
        }
    }
    options.class_filter = "dinosaur";
    EXPECT_TRUE(searcher.search(mesh("00_box.off"), options)->hits.empty());
}

TEST_F(SearcherTest, FindsSimilarModelsWithoutTheModelItself) {
    Searcher searcher = open();
    const auto similar = searcher.similar(6);
    ASSERT_TRUE(similar) << similar.error().message;
    EXPECT_EQ(similar->hits.size(), 8U);
    for (const Hit& hit : similar->hits) EXPECT_NE(hit.id, 6);
    EXPECT_EQ(kind(similar->hits[0]), "torus");
    EXPECT_FALSE(similar->query_skeleton.graph.empty());
    const auto none = searcher.similar(77);
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ErrorCode::kModelNotFound);
}

TEST_F(SearcherTest, ComparesIndexedModelsBothWaysAlike) {
    Searcher searcher = open();
    const auto there = searcher.compare(2, 5);
    const auto back = searcher.compare(5, 2);
    ASSERT_TRUE(there && back);
    EXPECT_NEAR(there->match.distance, back->match.distance, 1e-9);
    EXPECT_EQ(there->a.summary.name, "01_tree");
    EXPECT_EQ(there->b.summary.name, "04_tree");
    EXPECT_EQ(there->match.correspondence.nodes.size(), back->match.correspondence.nodes.size());
    EXPECT_NEAR(searcher.compare(2, 2)->match.distance, 0.0, 1e-9);
    EXPECT_FALSE(searcher.compare(2, 77));
}

TEST_F(SearcherTest, ComparesMeshesWithoutAnIndex) {
    const auto same = compare_meshes(mesh("01_tree.off"), mesh("01_tree.off"), test::kCoarse);
    ASSERT_TRUE(same);
    EXPECT_NEAR(same->match.distance, 0.0, 1e-9);
    const auto other = compare_meshes(mesh("01_tree.off"), mesh("02_torus.off"), test::kCoarse);
    ASSERT_TRUE(other);
    EXPECT_GT(other->match.distance, 0.0);
}

TEST_F(SearcherTest, RefusesAPoseOutsideItsRange) {
    Searcher searcher = open();
    for (const double pose : {-0.1, 1.1, std::nan("")}) {
        SearchOptions options;
        options.rank.pose = pose;
        EXPECT_EQ(searcher.search(mesh("01_tree.off"), options).error().code,
                  ErrorCode::kInvalidArgument);
        EXPECT_EQ(searcher.similar(1, options).error().code, ErrorCode::kInvalidArgument);
        EXPECT_EQ(searcher.compare(1, 2, options.rank).error().code, ErrorCode::kInvalidArgument);
    }
}

TEST_F(SearcherTest, TellsEachStageAsItBegins) {
    Searcher searcher = open();
    SearchOptions options;
    std::vector<std::string> told;
    options.on_stage = [&](std::string_view stage) { told.emplace_back(stage); };
    ASSERT_TRUE(searcher.search(mesh("04_tree.off"), options));
    EXPECT_EQ(told, (std::vector<std::string>{"voxelize", "distance_transform", "thin", "refine",
                                              "surface", "describe_skeleton", "global_descriptors",
                                              "turned_skeletons", "global_descriptors", "rank",
                                              "explain"}));
}

TEST_F(SearcherTest, GivesUpWhenAsked) {
    Searcher searcher = open();
    std::stop_source stop;
    stop.request_stop();
    const auto result = searcher.search(mesh("01_tree.off"), {}, stop.get_token());
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::kCancelled);
}

TEST_F(SearcherTest, AnswersSeveralThreadsAtOnceAlike) {
    Searcher searcher = open();
    const auto expected = searcher.similar(2);
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i) {
        threads.emplace_back([&] {
            const auto result = searcher.similar(2);
            ASSERT_TRUE(result);
            for (std::size_t h = 0; h < result->hits.size(); ++h) {
                EXPECT_EQ(result->hits[h].id, expected->hits[h].id);
                EXPECT_EQ(result->hits[h].distance, expected->hits[h].distance);
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
}

TEST_F(SearcherTest, FollowsTheIndex) {
    const fs::path copy = folder_->path() / "copy.index";
    fs::copy_file(index(), copy, fs::copy_options::overwrite_existing);
    auto searcher = Searcher::open(copy);
    ASSERT_TRUE(searcher);
    const auto before = *searcher->snapshot();
    EXPECT_EQ(*searcher->snapshot(), before) << "the same one while nothing changes";
    auto writer = Store::open(copy, Access::kReadWrite);
    ASSERT_TRUE(writer->remove(6));
    EXPECT_EQ((*searcher->snapshot())->size(), 8U);
    EXPECT_EQ(searcher->similar(6).error().code, ErrorCode::kModelNotFound);
    const Revision revision = (*searcher->snapshot())->revision();
    ASSERT_TRUE(update_statistics(*writer));
    EXPECT_EQ((*searcher->snapshot())->state().statistics, revision);
    EXPECT_EQ(before->size(), 9U);
}

TEST_F(SearcherTest, IsPresentedWithTheAgreedFields) {
    Searcher searcher = open();
    const auto result = searcher.search(mesh("01_tree.off"));
    const nlohmann::json json = to_json(*result, {"x", 10, 20}, ranking::RankOptions{});
    EXPECT_EQ(json["ranker"], "hybrid");
    EXPECT_EQ(json["models"], 9);
    EXPECT_EQ(json["query"]["name"], "x");
    EXPECT_EQ(json["query"]["skeleton"]["unit"], "model");
    EXPECT_TRUE(json["stages_ms"].contains("voxelize"));
    const nlohmann::json& hit = json["hits"][0];
    for (const char* field : {"rank", "id", "name", "class", "distance", "parts",
                              "build_difference", "pose_difference", "matched_nodes", "match"}) {
        EXPECT_TRUE(hit.contains(field)) << field;
    }
    EXPECT_EQ(hit["build_difference"], 0.0);
    EXPECT_EQ(hit["pose_difference"], 0.0);
    EXPECT_GT(json["hits"][1]["build_difference"].get<double>(), 0.0);
    EXPECT_TRUE(hit["parts"].contains("build"));
    EXPECT_TRUE(hit["parts"].contains("pose"));
    EXPECT_EQ(hit["class"], "tree");
    const nlohmann::json& skeleton = json["query"]["skeleton"];
    ASSERT_FALSE(skeleton["branches"].empty());
    const nlohmann::json& branch = skeleton["branches"][0];
    EXPECT_EQ(branch["points"].size(), branch["radii"].size());
    EXPECT_EQ(branch["points"][0].size(), 3U);
    EXPECT_TRUE(branch["chain_code"].is_string());

    const nlohmann::json compared = to_json(*searcher.compare(1, 2), ranking::RankOptions{});
    EXPECT_EQ(compared["a"]["id"], 1);
    EXPECT_TRUE(compared["skeletons"]["b"]["nodes"].is_array());
    const auto meshes = compare_meshes(mesh("01_tree.off"), mesh("02_torus.off"), test::kCoarse);
    EXPECT_TRUE(to_json(*meshes, ranking::RankOptions{})["a"].contains("name"));
}

TEST_F(SearcherTest, EvaluatesASampleWhichIsTheSameEachTime) {
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

TEST_F(SearcherTest, EvaluatesTheClassesOfTheIndex) {
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

TEST_F(SearcherTest, EvaluatesJustTheModelsOfAClassificationInItsOrder) {
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

TEST_F(SearcherTest, ExplainsAPairAlikeInASearchAndInAComparison) {
    Searcher searcher = open();
    for (const ranking::RankerKind ranker : ranking::kAllRankers) {
        for (const bool part : {false, true}) {
            SearchOptions options;
            options.rank.ranker = ranker;
            options.rank.part = part;
            const auto result = searcher.similar(2, options);
            ASSERT_TRUE(result);
            ASSERT_EQ(result->hits.size(), 8U);
            for (const Hit& hit : result->hits) {
                const nlohmann::json shown = to_json(hit);
                const nlohmann::json compared =
                    to_json(*searcher.compare(2, hit.id, options.rank), options.rank);
                for (const char* field : {"distance", "parts", "matched_nodes", "match"}) {
                    // A search for a part looks at surfaces, too.
                    if (part && shown[field].dump() != compared[field].dump()) {
                        EXPECT_TRUE(field == std::string("distance") ||
                                    field == std::string("parts"));
                        continue;
                    }
                    EXPECT_EQ(shown[field], compared[field]) << to_string(ranker) << ' ' << field;
                }
                double sum = 0.0;
                for (const auto& [name, value] : shown["parts"].items()) sum += value.get<double>();
                EXPECT_NEAR(sum, hit.distance, 1e-4) << to_string(ranker);
                std::size_t clustered = 0;
                for (const std::uint32_t size : hit.match.cluster_sizes) clustered += size;
                EXPECT_EQ(clustered, hit.matched_nodes);
                EXPECT_EQ(hit.match.nodes.size(), hit.matched_nodes);
            }
        }
    }
}

TEST_F(SearcherTest, FindsAModelFirstAsAPartOfItself) {
    Searcher searcher = open();
    SearchOptions options;
    options.rank.part = true;
    const auto result = searcher.search(mesh("01_tree.off"), options);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(result->hits[0].name, "01_tree");
    EXPECT_LT(result->hits[0].distance, 0.1);
    ASSERT_TRUE(result->hits[0].placement);
    EXPECT_NEAR(result->hits[0].placement->placement.scale, 1.0, 0.02);
    EXPECT_GT(result->hits[0].placement->explained, 0.95);
    options.rank.rerank = true;
    EXPECT_EQ(searcher.search(mesh("01_tree.off"), options).error().code,
              ErrorCode::kInvalidArgument);
}

TEST_F(SearcherTest, FindsAPieceOfAModelWhereItWasCutFrom) {
    Searcher searcher = open();
    const mesh::TriangleMesh whole = mesh("01_tree.off");
    mesh::TriangleMesh piece = whole;
    const Box3 bounds = mesh::measure(whole).bounds;
    int axis = 0;
    bounds.sizes().maxCoeff(&axis);
    std::erase_if(piece.triangles, [&](const auto& triangle) {
        return whole.vertices[triangle[0]][axis] < bounds.center()[axis];
    });
    ASSERT_LT(piece.triangles.size(), whole.triangles.size());
    piece.face_of_triangle.resize(piece.triangles.size());
    const Mat3 turn = test::random_rotation(5);
    piece = test::transformed(piece, 4.0 * turn, Vec3(1, 2, 3));
    SearchOptions options;
    options.rank.part = true;
    const auto result = searcher.search(piece, options);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(kind(result->hits[0]), "tree");
    const auto own = std::find_if(result->hits.begin(), result->hits.end(),
                                  [](const Hit& hit) { return hit.name == "01_tree"; });
    ASSERT_TRUE(own != result->hits.end() && own->placement);
    EXPECT_NEAR(own->placement->placement.scale, 0.25, 0.01);
    EXPECT_GT(own->placement->explained, 0.9);
    const nlohmann::json shown = to_json(*own)["placement"];
    ASSERT_EQ(shown["matrix"].size(), 4U);
    EXPECT_EQ(shown["matrix"][3], nlohmann::json({0.0, 0.0, 0.0, 1.0}));
    // The same for every number of jobs.
    options.rank.jobs = 4;
    const auto again = searcher.search(piece, options);
    for (std::size_t i = 0; i < result->hits.size(); ++i) {
        EXPECT_EQ(to_json(again->hits[i]), to_json(result->hits[i]));
    }
}

TEST_F(SearcherTest, SaysOfHowManyModelsTheSurfaceIsNotKnown) {
    test::TemporaryFolder folder;
    const fs::path copy = folder.path() / "y.index";
    fs::copy_file(index(), copy);
    test::execute_sql(copy, "DELETE FROM surface_features WHERE model = 2");
    auto searcher = *Searcher::open(copy);
    SearchOptions options;
    options.rank.part = true;
    const auto result = searcher.search(mesh("01_tree.off"), options);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(result->hits.size(), 9U);
    const auto told =
        std::find_if(result->warnings.begin(), result->warnings.end(),
                     [](const auto& each) { return each.code == "features_missing"; });
    ASSERT_TRUE(told != result->warnings.end());
    EXPECT_EQ(told->count, 1U);
    for (const Hit& hit : result->hits) {
        if (hit.id == 2) {
            EXPECT_FALSE(hit.placement);
        }
    }
}

TEST_F(SearcherTest, MakesFeaturesThatAnEarlierIndexLacksAsTheyAreMadeToday) {
    test::TemporaryFolder folder;
    const fs::path copy = folder.path() / "y.index";
    fs::copy_file(index(), copy);
    auto store = *Store::open(copy, Access::kReadWrite);
    const auto before = *store.features(0, 100);
    ASSERT_EQ(before.size(), 9U);
    test::execute_sql(copy, "DELETE FROM surface_features WHERE model <> 3");
    EXPECT_EQ(store.without_features(0, 100)->size(), 8U);
    const Revision revision = *store.revision();
    EXPECT_EQ(*add_missing_features(store, 2), 8U);
    EXPECT_EQ(*store.revision(), revision);
    EXPECT_EQ(*add_missing_features(store, 2), 0U);
    const auto after = *store.features(0, 100);
    ASSERT_EQ(after.size(), before.size());
    for (std::size_t i = 0; i < after.size(); ++i) {
        EXPECT_EQ(encode_features(after[i].features), encode_features(before[i].features));
    }
    std::stop_source stopped;
    stopped.request_stop();
    EXPECT_EQ(add_missing_features(store, 2, stopped.get_token()).error().code,
              ErrorCode::kCancelled);
}

TEST_F(SearcherTest, ShowsModelsBesideTheNearestOfTheirClassByBuildAndByPose) {
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

TEST_F(SearcherTest, MeasuresBuildAndPoseAtSeveralWeights) {
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

TEST_F(SearcherTest, KeepsEvaluationsUntilTheIndexChanges) {
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
