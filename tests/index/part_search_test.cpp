#include <gtest/gtest.h>

#include <algorithm>

#include "engine/mesh/measures.h"
#include "index/codec.h"
#include "index/missing_features.h"
#include "index/presentation.h"
#include "tests/index/small_collection.h"
#include "tests/support/shapes.h"

namespace ossuary::index {
namespace {

namespace fs = std::filesystem;

using PartSearch = SmallCollection;

TEST_F(PartSearch, FindsAModelFirstAsAPartOfItself) {
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

TEST_F(PartSearch, FindsAPieceOfAModelWhereItWasCutFrom) {
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

TEST_F(PartSearch, SaysOfHowManyModelsTheSurfaceIsNotKnown) {
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

TEST_F(PartSearch, MakesFeaturesThatAnEarlierIndexLacksAsTheyAreMadeToday) {
    test::TemporaryFolder folder;
    const fs::path copy = folder.path() / "y.index";
    fs::copy_file(index(), copy);
    auto store = *Store::open(copy, Access::kReadWrite);
    const auto before = *store.features(0, 100);
    ASSERT_EQ(before.size(), 9U);
    test::execute_sql(copy, "DELETE FROM surface_features WHERE model <> 3");
    EXPECT_EQ(store.without_features(0, 100)->size(), 8U);
    const Revision revision = *store.revision();
    ProgressSink quiet;
    EXPECT_EQ(*add_missing_features(store, 2, quiet), 8U);
    EXPECT_EQ(*store.revision(), revision);
    EXPECT_EQ(*add_missing_features(store, 2, quiet), 0U);
    const auto after = *store.features(0, 100);
    ASSERT_EQ(after.size(), before.size());
    for (std::size_t i = 0; i < after.size(); ++i) {
        EXPECT_EQ(encode_features(after[i].features), encode_features(before[i].features));
    }
    std::stop_source stopped;
    stopped.request_stop();
    EXPECT_EQ(add_missing_features(store, 2, quiet, stopped.get_token()).error().code,
              ErrorCode::kCancelled);
}

}  // namespace
}  // namespace ossuary::index
