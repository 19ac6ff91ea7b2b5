// An index that is replaced by another file, or removed, while programs have it open.

#include <gtest/gtest.h>

#include "index/evaluation.h"
#include "index/searcher.h"
#include "index/snapshot.h"
#include "index/store.h"
#include "tests/index/sample_index.h"

namespace ossuary::index {
namespace {

namespace fs = std::filesystem;

class ReplacedIndex : public testing::Test {
protected:
    static void make(const fs::path& path, std::uint64_t seed,
                     const IndexParameters& parameters = {}) {
        auto store = Store::create_or_open(path, parameters);
        ASSERT_TRUE(store) << store.error().message;
        ASSERT_TRUE(store->put(test::sample_model(seed, "/m/" + std::to_string(seed) + ".off")));
        ASSERT_TRUE(store->put_statistics({{1.0}}, *store->revision()));
    }
    void SetUp() override {
        make(path_, 1);
        make(new_, 2);
    }
    static std::string only_name(Store& store) {
        const auto page = store.models();
        EXPECT_TRUE(page) << page.error().message;
        if (!page) return "";
        EXPECT_EQ(page->total, 1U);
        return page->models.front().name;
    }
    /// The file alone, as it is on the disk, is a sound index with only this model.
    static void expect_whole(const fs::path& path, const std::string& name) {
        test::TemporaryFolder elsewhere;
        const fs::path copy = elsewhere.path() / "copy.index";
        fs::copy_file(path, copy);
        auto store = Store::open(copy, Access::kReadOnly);
        ASSERT_TRUE(store) << store.error().message;
        EXPECT_EQ(only_name(*store), name);
        test::expect_sound(*store);
    }

    test::TemporaryFolder folder_;
    fs::path path_ = folder_.path() / "x.index";
    fs::path new_ = folder_.path() / "new.index";
};

TEST_F(ReplacedIndex, IsNotWrittenUnnoticed) {
    auto store = Store::open(path_, Access::kReadWrite);
    ASSERT_TRUE(store);
    ASSERT_TRUE(store->put(test::sample_model(1, "/m/1.off")));
    fs::rename(new_, path_);
    for (int i = 0; i < 2; ++i) {
        const auto put = store->put(test::sample_model(3, "/m/3.off"));
        ASSERT_FALSE(put);
        EXPECT_EQ(put.error().code, ErrorCode::kIndexReplaced);
        EXPECT_EQ(store->models().error().code, ErrorCode::kIndexReplaced);
    }
    expect_whole(path_, "2");
}

TEST_F(ReplacedIndex, IsFollowedByAllStoresThatAreToldTo) {
    auto searcher = Searcher::open(path_);
    auto writer = Store::open(path_, Access::kReadWrite);
    ASSERT_TRUE(searcher && writer);
    searcher->store().follow_replacements();
    writer->follow_replacements();
    // Same revision, other models; and something in the log of the old one.
    ASSERT_TRUE(writer->put_statistics({{2.0}}, 1));
    const auto before = *searcher->snapshot();
    const auto name_in = [&](const Snapshot& snapshot) {
        return std::string((**snapshot.catalogue(searcher->store()))[0].name);
    };
    ASSERT_EQ(name_in(*before), "1");
    fs::rename(new_, path_);
    const auto after = searcher->snapshot();
    ASSERT_TRUE(after) << after.error().message;
    EXPECT_EQ(name_in(**after), "2");
    EXPECT_EQ((*after)->revision(), before->revision());
    EXPECT_NE((*after)->measures(0), before->measures(0));
    ASSERT_TRUE(writer->remove(1));
    ASSERT_TRUE(writer->put(test::sample_model(3, "/m/3.off")));
    ASSERT_TRUE(writer->put_statistics({{1.0}}, *writer->revision()));
    EXPECT_EQ(name_in(**searcher->snapshot()), "3");
    ASSERT_TRUE(writer->checkpoint());
    expect_whole(path_, "3");
}

TEST_F(ReplacedIndex, KeepsWhatWasInItsLogWhereItHasGone) {
    const fs::path aside = folder_.path() / "aside.index";
    auto store = Store::open(path_, Access::kReadWrite);
    auto reader = Store::open(path_, Access::kReadOnly);
    ASSERT_TRUE(store && reader);
    ASSERT_TRUE(store->put(test::sample_model(5, "/m/1.off")));
    ASSERT_TRUE(store->put_statistics({{1.0}}, *store->revision()));
    fs::rename(path_, aside);
    fs::rename(new_, path_);
    EXPECT_EQ(reader->models().error().code, ErrorCode::kIndexReplaced);
    expect_whole(aside, "1");
    auto moved = Store::open(aside, Access::kReadOnly);
    ASSERT_TRUE(moved);
    EXPECT_EQ(moved->model(1)->content_hash, test::sample_model(5, "").summary.content_hash);
    expect_whole(path_, "2");
}

TEST_F(ReplacedIndex, MayBeRemovedAndMadeAnew) {
    auto store = Store::open(path_, Access::kReadWrite);
    ASSERT_TRUE(store);
    store->follow_replacements();
    ASSERT_TRUE(store->put(test::sample_model(3, "/m/3.off")));
    fs::remove(path_);
    EXPECT_EQ(store->put(test::sample_model(4, "/m/4.off")).error().code,
              ErrorCode::kIndexNotFound);
    EXPECT_FALSE(fs::exists(path_)) << "nothing is made in its place";
    make(path_, 6);
    EXPECT_EQ(only_name(*store), "6");
    EXPECT_EQ(store->collection_state()->replacements, 1U);
    ASSERT_TRUE(store->checkpoint());
    expect_whole(path_, "6");
}

TEST_F(ReplacedIndex, ByOneOfOtherParametersIsNotFollowed) {
    auto store = Store::open(path_, Access::kReadWrite);
    ASSERT_TRUE(store);
    store->follow_replacements();
    const fs::path other = folder_.path() / "other.index";
    make(other, 7, {.resolution = 64});
    fs::rename(other, path_);
    const auto models = store->models();
    ASSERT_FALSE(models);
    EXPECT_EQ(models.error().code, ErrorCode::kIndexReplaced);
    EXPECT_NE(models.error().message.find("resolution 64"), std::string::npos);
    fs::rename(new_, path_);
    EXPECT_EQ(only_name(*store), "2") << "as soon as it fits again";
}

TEST_F(ReplacedIndex, ByWhatIsNoIndexIsSaidSo) {
    auto store = Store::open(path_, Access::kReadWrite);
    ASSERT_TRUE(store);
    store->follow_replacements();
    test::write_file(new_, "no index");
    fs::rename(new_, path_);
    EXPECT_EQ(store->models().error().code, ErrorCode::kIndexForeign);
    EXPECT_EQ(test::read_file(path_), "no index");
}

TEST_F(ReplacedIndex, TakesNothingThatWasComputedFromTheOldOne) {
    auto store = Store::open(path_, Access::kReadWrite);
    ASSERT_TRUE(store);
    store->follow_replacements();
    const auto snapshot = *Snapshot::load(*store);
    fs::rename(new_, path_);
    const auto state = snapshot->state();
    EXPECT_EQ(store->put_statistics({{9.0}}, state.models, state.replacements).error().code,
              ErrorCode::kIndexReplaced);
    const EvaluationKey key{state.models, ranking::RankerKind::kHybrid, false,
                            0.15,         std::string(32, '0'),         state.replacements};
    EXPECT_EQ(store->put_evaluation(key, test::sample_report(1)).error().code,
              ErrorCode::kIndexReplaced);
    EXPECT_FALSE(*store->evaluation(key));
    EXPECT_TRUE(store->evaluations()->empty());
    EXPECT_EQ((*store->statistics())->statistics.values.front(), 1.0);
}

TEST_F(ReplacedIndex, IsNoticedWhenALinkIsTurned) {
    const fs::path link = folder_.path() / "current.index";
    fs::create_symlink(path_, link);
    auto store = Store::open(link, Access::kReadWrite);
    ASSERT_TRUE(store);
    store->follow_replacements();
    EXPECT_EQ(only_name(*store), "1");
    const fs::path turned = folder_.path() / "turned";
    fs::create_symlink(new_, turned);
    fs::rename(turned, link);
    EXPECT_EQ(only_name(*store), "2");
}

}  // namespace
}  // namespace ossuary::index
