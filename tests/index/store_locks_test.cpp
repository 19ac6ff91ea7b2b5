// POSIX gives up all of a process's locks on a file when any of its descriptors is closed: whatever
// else the process does with an index that it has open, the locks must stay.

#include <gtest/gtest.h>

#include "index/evaluation.h"
#include "index/indexer.h"
#include "index/searcher.h"
#include "index/store.h"
#include "tests/index/file_locks.h"
#include "tests/index/sample_index.h"

namespace ossuary::index {
namespace {

namespace fs = std::filesystem;

class StoreLocks : public testing::TestWithParam<Access> {
protected:
    void SetUp() override {
        auto store = Store::create_or_open(path_, test::kCoarse);
        ASSERT_TRUE(store) << store.error().message;
        ASSERT_TRUE(store->put(test::sample_model(1, "/m/a.off")));
        ASSERT_TRUE(store->put_statistics({{1.0}}, *store->revision()));
    }

    test::TemporaryFolder folder_;
    fs::path path_ = folder_.path() / "x.index";
};

TEST_P(StoreLocks, AreHeldWhileAStoreIsOpen) {
    EXPECT_FALSE(test::holds_lock(path_)) << "nothing has it open";
    {
        auto store = Store::open(path_, GetParam());
        ASSERT_TRUE(store);
        ASSERT_TRUE(store->revision());
        EXPECT_TRUE(test::holds_lock(path_));
    }
    EXPECT_FALSE(test::holds_lock(path_));
}

TEST_P(StoreLocks, SurviveOtherStoresOfTheSameFile) {
    auto store = Store::open(path_, GetParam());
    ASSERT_TRUE(store);
    ASSERT_TRUE(store->revision());
    for (const Access access : {Access::kReadOnly, Access::kReadWrite}) {
        {
            auto other = Store::open(path_, access);
            ASSERT_TRUE(other);
            ASSERT_TRUE(other->verify());
        }
        EXPECT_TRUE(test::holds_lock(path_));
    }
    { ASSERT_TRUE(Store::create_or_open(path_, test::kCoarse)); }
    EXPECT_TRUE(test::holds_lock(path_));
    EXPECT_FALSE(Store::create_or_open(path_, {.resolution = 96})) << "other parameters";
    EXPECT_TRUE(test::holds_lock(path_));
    { ASSERT_TRUE(Searcher::open(path_)); }
    EXPECT_TRUE(test::holds_lock(path_));
}

TEST_P(StoreLocks, SurviveALookAtTheFileUnderAnotherName) {
    auto store = Store::open(path_, GetParam());
    ASSERT_TRUE(store);
    ASSERT_TRUE(store->revision());
    const fs::path link = folder_.path() / "link.index";
    fs::create_symlink(path_, link);
    { ASSERT_TRUE(Store::open(link, Access::kReadWrite)); }
    EXPECT_TRUE(test::holds_lock(path_));
}

TEST_P(StoreLocks, SurviveIndexingAFolderThatTheIndexLiesIn) {
    const fs::path models = folder_.path() / "models";
    test::write_sample_meshes(models, 1);
    const fs::path inside = models / "index.off";
    auto store = Store::create_or_open(inside, test::kCoarse);
    ASSERT_TRUE(store);
    ProgressSink quiet;
    IndexOptions options;
    options.paths = {models, inside.string() + "-wal"};
    const auto outcome = index_models(*store, options, quiet);
    ASSERT_TRUE(outcome) << outcome.error().message;
    EXPECT_TRUE(test::holds_lock(inside));
    EXPECT_EQ(outcome->indexed, 1U);
    EXPECT_EQ(outcome->failed, 2U);
    EXPECT_NE(store->failures()->front().message.find("is the index itself"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Access, StoreLocks, testing::Values(Access::kReadOnly, Access::kReadWrite),
                         [](const auto& each) {
                             return each.param == Access::kReadOnly ? "Reader" : "Writer";
                         });

}  // namespace
}  // namespace ossuary::index
