#include "index/query_model.h"

#include <gtest/gtest.h>

#include "engine/mesh/measures.h"
#include "tests/index/sample_index.h"
#include "tests/support/shapes.h"

namespace ossuary::index {
namespace {

class QueryModelTest : public testing::Test {
protected:
    QueryModelTest() {
        EXPECT_TRUE(Store::create_or_open(file_, test::kCoarse));
        searcher_ = std::make_unique<Searcher>(*Searcher::open(file_));
    }
    std::unique_ptr<QueryModel> model_of(const mesh::TriangleMesh& mesh) {
        auto described = searcher_->describe(mesh);
        EXPECT_TRUE(described);
        return std::make_unique<QueryModel>(
            "tree", mesh, std::vector<mesh::MeshWarning>{{"read", 1, "of reading"}}, FileFrame{},
            *std::move(described));
    }

    test::TemporaryFolder folder_;
    std::filesystem::path file_ = folder_.path() / "x.ossuary";
    std::unique_ptr<Searcher> searcher_;
};

TEST_F(QueryModelTest, HasThePartsOfItsPreview) {
    const auto model = model_of(test::capsule_tree_mesh());
    const auto preview = model->preview();
    ASSERT_TRUE(preview);
    EXPECT_LE(preview->triangles.size(), 3u * 2000u);
    const auto segments = model->segments();
    ASSERT_TRUE(segments) << segments.error().message;
    EXPECT_EQ(segments->labels.size() * 3, preview->triangles.size());
    EXPECT_GT(segments->parts.size(), 1u);
    EXPECT_EQ(model->segments()->labels, segments->labels);
    EXPECT_EQ(model->warnings().front().code, "read");
    EXPECT_TRUE(model->bounds().isApprox(mesh::measure(test::capsule_tree_mesh()).bounds));
    EXPECT_TRUE(model->up());
}

TEST_F(QueryModelTest, MakesNothingOfWhatWasGivenUp) {
    const auto model = model_of(test::capsule_tree_mesh());
    std::stop_source stopped;
    stopped.request_stop();
    EXPECT_EQ(model->preview(stopped.get_token()).error().code, ErrorCode::kCancelled);
    EXPECT_EQ(model->segments(stopped.get_token()).error().code, ErrorCode::kCancelled);
    EXPECT_TRUE(model->segments());
}

TEST_F(QueryModelTest, CountsTheMemoryOfItsMeshes) {
    const auto small = model_of(test::torus_mesh(2.0, 0.5, 16, 8));
    const auto large = model_of(test::torus_mesh(2.0, 0.5, 160, 80));
    EXPECT_GE(large->bytes() - small->bytes(), (160u * 80u - 16u * 8u) * (24u + 2u * 12u));
}

}  // namespace
}  // namespace ossuary::index
