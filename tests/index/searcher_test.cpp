#include "index/searcher.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

#include "engine/mesh/measures.h"
#include "index/presentation.h"
#include "tests/index/small_collection.h"
#include "tests/support/shapes.h"

namespace ossuary::index {
namespace {

namespace fs = std::filesystem;

using SearcherTest = SmallCollection;

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

}  // namespace
}  // namespace ossuary::index
