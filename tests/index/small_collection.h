#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/mesh/read_mesh.h"
#include "index/indexer.h"
#include "index/searcher.h"
#include "tests/index/sample_index.h"

namespace ossuary::index {

/// One small collection for all tests of a suite: boxes, trees and tori by turns.
class SmallCollection : public testing::Test {
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
    static std::filesystem::path models() { return folder_->path() / "models"; }
    static std::filesystem::path index() { return folder_->path() / "x.index"; }

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

    static inline std::unique_ptr<test::TemporaryFolder> folder_;
};

}  // namespace ossuary::index
