#include "index/keep_indexed.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <thread>

#include "tests/index/sample_index.h"

namespace ossuary::index {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

/// Keeps what it hears, for a thread that waits for it.
class Heard : public KeepSink {
public:
    void ran(const IndexOutcome& outcome) override {
        add([&] { outcomes_.push_back(outcome); });
    }
    void run_failed(const Error& error) override {
        add([&] { errors_.push_back(error); });
    }
    void missing(const std::vector<fs::path>& paths) override {
        add([&] { missing_ = paths; });
    }
    void untold(const std::vector<fs::path>&) override {}

    /// Whether `condition` of the last outcome becomes true; each is a minute's patience.
    template <typename Condition>
    bool until(const Condition& condition) {
        std::unique_lock lock(mutex_);
        return changed_.wait_for(lock, 60s,
                                 [&] { return !outcomes_.empty() && condition(outcomes_.back()); });
    }
    std::size_t runs() {
        const std::lock_guard lock(mutex_);
        return outcomes_.size();
    }
    std::vector<fs::path> missing_paths() {
        const std::lock_guard lock(mutex_);
        return missing_;
    }
    std::vector<Error> errors() {
        const std::lock_guard lock(mutex_);
        return errors_;
    }

private:
    template <typename Change>
    void add(const Change& change) {
        {
            const std::lock_guard lock(mutex_);
            change();
        }
        changed_.notify_all();
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<IndexOutcome> outcomes_;
    std::vector<Error> errors_;
    std::vector<fs::path> missing_;
};

class KeepIndexed : public testing::Test {
protected:
    KeepIndexed() {
        test::write_sample_meshes(stock_, 4);
        fs::create_directories(models_);
        options_.folders.settle = 20ms;
        options_.folders.ignored = {index_};
        indexing_.paths = {models_};
        indexing_.jobs = 1;
        indexing_.prune = Prune::kYes;
    }
    ~KeepIndexed() override { stop(); }

    void start() {
        auto store = Store::create_or_open(index_, test::kCoarse);
        ASSERT_TRUE(store) << store.error().message;
        store_.emplace(*std::move(store));
        thread_ = std::jthread([this](const std::stop_token& stop) {
            EXPECT_TRUE(keep_indexed(*store_, indexing_, options_, heard_, stop));
        });
        ASSERT_TRUE(heard_.until([](const IndexOutcome&) { return true; }));
    }
    void stop() {
        if (!thread_.joinable()) return;
        thread_.request_stop();
        thread_.join();
    }
    void copy(const std::string& name, const fs::path& to) {
        fs::create_directories(to.parent_path());
        fs::copy_file(stock_ / name, to, fs::copy_options::overwrite_existing);
    }
    /// Paths and ids of the models, as another reader of the index sees them.
    std::map<fs::path, ModelId> models() {
        std::map<fs::path, ModelId> found;
        auto store = Store::open(index_, Access::kReadOnly);
        EXPECT_TRUE(store);
        ModelFilter everything;
        everything.limit = 0;
        const auto page = store->models(everything);
        EXPECT_TRUE(page);
        for (const auto& model : page->models) found[model.path] = model.id;
        return found;
    }

    test::TemporaryFolder folder_;
    fs::path stock_ = folder_.path() / "stock";
    fs::path models_ = folder_.path() / "models";
    fs::path index_ = folder_.path() / "models/x.ossuary";  // beneath what is watched
    IndexOptions indexing_;
    KeepOptions options_;
    Heard heard_;
    std::optional<Store> store_;
    std::jthread thread_;
};

TEST_F(KeepIndexed, FollowsFilesThatComeChangeMoveAndGo) {
    copy("00_box.off", models_ / "a.off");
    start();
    ASSERT_EQ(models().size(), 1U);
    const ModelId first = models().at(models_ / "a.off");

    copy("01_tree.off", models_ / "b.off");
    ASSERT_TRUE(heard_.until([](const IndexOutcome& run) { return run.indexed == 1; }));
    ASSERT_TRUE(heard_.until([](const IndexOutcome& run) { return run.files == 2; }));
    EXPECT_EQ(models().count(models_ / "b.off"), 1U);

    copy("02_torus.off", models_ / "b.off");
    ASSERT_TRUE(heard_.until(
        [](const IndexOutcome& run) { return run.indexed == 1 && run.unchanged == 1; }));

    fs::rename(models_ / "a.off", models_ / "moved.off");
    ASSERT_TRUE(heard_.until([](const IndexOutcome& run) { return run.moved == 1; }));
    EXPECT_EQ(models().at(models_ / "moved.off"), first) << "a moved file keeps its number";

    fs::remove(models_ / "b.off");
    ASSERT_TRUE(heard_.until([](const IndexOutcome& run) { return run.pruned == 1; }));
    EXPECT_EQ(models().size(), 1U);
    EXPECT_TRUE(heard_.errors().empty());
}

TEST_F(KeepIndexed, SeesFoldersThatAreMadeLater) {
    copy("00_box.off", models_ / "a.off");
    start();
    copy("01_tree.off", models_ / "new/deeper/b.off");
    ASSERT_TRUE(heard_.until([](const IndexOutcome& run) { return run.files == 2; }));
    copy("02_torus.off", models_ / "new/deeper/c.off");
    ASSERT_TRUE(heard_.until([](const IndexOutcome& run) { return run.files == 3; }));
    fs::create_directory_symlink(stock_, models_ / "linked");
    ASSERT_TRUE(heard_.until([](const IndexOutcome& run) { return run.files == 7; }));
}

TEST_F(KeepIndexed, IsNotWokenByItsOwnIndexNorByHiddenFiles) {
    copy("00_box.off", models_ / "a.off");
    start();
    copy("01_tree.off", models_ / "b.off");
    ASSERT_TRUE(heard_.until([](const IndexOutcome& run) { return run.files == 2; }));
    // The run after that one may have been asked for while it went on.
    std::this_thread::sleep_for(300ms);
    const std::size_t runs = heard_.runs();
    test::write_file(models_ / ".hidden", "x");
    test::write_file(models_ / "x.ossuary-journal", "x");
    std::this_thread::sleep_for(300ms);
    EXPECT_EQ(heard_.runs(), runs);
}

TEST_F(KeepIndexed, KeepsTheModelsOfADiskThatIsNotThere) {
    const fs::path disk = folder_.path() / "disk";
    copy("00_box.off", disk / "a.off");
    indexing_.paths = {models_, disk};
    options_.folders.rescan = 100ms;
    start();
    ASSERT_EQ(models().size(), 1U);
    fs::rename(disk, folder_.path() / "elsewhere");
    ASSERT_TRUE(heard_.until([](const IndexOutcome& run) { return run.refusals.size() == 1; }));
    EXPECT_EQ(heard_.missing_paths(), std::vector{disk});
    EXPECT_EQ(models().size(), 1U);
    fs::rename(folder_.path() / "elsewhere", disk);
    ASSERT_TRUE(heard_.until(
        [](const IndexOutcome& run) { return run.refusals.empty() && run.unchanged == 1; }));
    EXPECT_TRUE(heard_.missing_paths().empty());
}

TEST_F(KeepIndexed, WaitsForAFolderThatHasNeverBeenThere) {
    const fs::path later = folder_.path() / "later";
    indexing_.paths = {models_, later};
    options_.folders.rescan = 100ms;
    copy("00_box.off", models_ / "a.off");
    start();
    EXPECT_EQ(heard_.missing_paths(), std::vector{later});
    EXPECT_EQ(models().size(), 1U);
    copy("01_tree.off", later / "b.off");
    ASSERT_TRUE(heard_.until([](const IndexOutcome& run) { return run.files == 2; }));
    EXPECT_TRUE(heard_.missing_paths().empty());
}

TEST_F(KeepIndexed, IsContentWithNothingUntilThereIsSomething) {
    copy("00_box.off", models_ / "a.off");
    start();
    stop();
    // A path of which neither the disk nor the index knows anything, alone: nothing to be done.
    indexing_.paths = {folder_.path() / "nowhere"};
    options_.folders.rescan = 50ms;
    thread_ = std::jthread([this](const std::stop_token& stop) {
        EXPECT_TRUE(keep_indexed(*store_, indexing_, options_, heard_, stop));
    });
    const auto looked_for = std::vector{folder_.path() / "nowhere"};
    for (int i = 0; i < 600 && heard_.missing_paths() != looked_for; ++i) {
        std::this_thread::sleep_for(100ms);
    }
    EXPECT_EQ(heard_.missing_paths(), looked_for);
    copy("01_tree.off", folder_.path() / "nowhere/b.off");
    for (int i = 0; i < 600 && models().size() < 2; ++i) std::this_thread::sleep_for(100ms);
    EXPECT_EQ(models().size(), 2U);
    EXPECT_TRUE(heard_.errors().empty());
}

TEST(FolderWatch, WatchesWhatIsBelowAFolderWhoseFileIsNamedToo) {
    const test::TemporaryFolder folder;
    fs::create_directories(folder.path() / "sub");
    test::write_file(folder.path() / "a.off", "a");
    FolderWatchOptions options;
    options.settle = 10ms;
    options.rescan = 20s;
    auto watch = FolderWatch::open({folder.path() / "a.off", folder.path()}, options);
    ASSERT_TRUE(watch);
    watch->refresh();
    test::write_file(folder.path() / "sub/b.off", "b");
    EXPECT_EQ(watch->wait({}), FolderWatch::Reason::kChange);
    EXPECT_TRUE(watch->untold().empty());
}

TEST(FolderWatch, WaitsUntilChangesHaveSettled) {
    const test::TemporaryFolder folder;
    FolderWatchOptions options;
    options.settle = 200ms;
    auto watch = FolderWatch::open({folder.path()}, options);
    ASSERT_TRUE(watch);
    watch->refresh();
    std::jthread writer([&] {
        for (int i = 0; i < 5; ++i) {
            test::write_file(folder.path() / "a.off", std::to_string(i));
            std::this_thread::sleep_for(20ms);
        }
    });
    EXPECT_EQ(watch->wait({}), FolderWatch::Reason::kChange);
    writer.join();
    EXPECT_EQ(test::read_file(folder.path() / "a.off"), "4") << "all writes are one change";
    options.rescan = 50ms;
    auto other = FolderWatch::open({folder.path()}, options);
    ASSERT_TRUE(other);
    other->refresh();
    EXPECT_EQ(other->wait({}), FolderWatch::Reason::kRescan);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_EQ(other->wait(stop.get_token()), FolderWatch::Reason::kStop);
}

}  // namespace
}  // namespace ossuary::index
