#include "server/statistics_updater.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <string_view>

#include "index/describe_model.h"
#include "tests/index/sample_index.h"
#include "tests/server/test_server.h"

namespace ossuary::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using When = server::StatisticsUpdater::When;

class StatisticsUpdaterTest : public testing::Test {
protected:
    TemporaryFolder folder_;
    fs::path index_ = copy_of_built_index(folder_.path());
    server::Log log_{{.level = "off"}};

    index::Store open() { return *index::Store::open(index_, index::Access::kReadWrite); }
    static bool current(index::Store& store) {
        const auto state = store.collection_state();
        return state && state->statistics == state->models;
    }
    static bool eventually(const std::function<bool()>& condition) {
        for (int i = 0; i < 3000 && !condition(); ++i) std::this_thread::sleep_for(10ms);
        return condition();
    }
};

TEST_F(StatisticsUpdaterTest, FollowsRemovalsAndNothingElse) {
    index::Searcher searcher = *index::Searcher::open(index_);
    index::Store store = open();
    server::StatisticsUpdater updater(open(), searcher, log_);
    ASSERT_TRUE(current(store));
    ASSERT_TRUE(store.remove(1));
    ASSERT_FALSE(current(store));
    // Missing ones would be made; these are only old.
    updater.request(When::kMissing);
    updater.request(When::kMissing);
    EXPECT_FALSE(current(store));
    updater.request(When::kOutdated);
    updater.request(When::kMissing);  // does not take the place of the one before
    EXPECT_TRUE(eventually([&] { return current(store); }));
}

TEST_F(StatisticsUpdaterTest, CatchesUpWithManyRemovals) {
    index::Searcher searcher = *index::Searcher::open(index_);
    index::Store store = open();
    server::StatisticsUpdater updater(open(), searcher, log_);
    for (index::ModelId id = 1; id <= 4; ++id) {
        ASSERT_TRUE(store.remove(id));
        updater.request(When::kOutdated);
    }
    EXPECT_TRUE(eventually([&] { return current(store); }));
    EXPECT_EQ((*searcher.snapshot())->size(), 2u);
    EXPECT_EQ((*searcher.snapshot())->state().statistics, (*searcher.snapshot())->revision());
}

TEST_F(StatisticsUpdaterTest, MakesThoseOfAnIndexThatHasNone) {
    const fs::path fresh = folder_.path() / "fresh.ossuary";
    index::Store store = *index::Store::create_or_open(fresh, index::IndexParameters{});
    ASSERT_TRUE(
        store.put(*index::describe_model({built_models()[0].off, "ball"}, store.parameters())));
    ASSERT_LT(store.collection_state()->statistics, 0);
    index::Searcher searcher = *index::Searcher::open(fresh);
    server::StatisticsUpdater updater(*index::Store::open(fresh, index::Access::kReadWrite),
                                      searcher, log_);
    updater.request(When::kMissing);
    EXPECT_TRUE(eventually([&] { return current(store); }));
}

/// What is written to stderr meanwhile, in a file.
class StderrInFile {
public:
    explicit StderrInFile(fs::path path) : path_(std::move(path)), saved_(dup(STDERR_FILENO)) {
        const int file = ::open(path_.c_str(), O_CREAT | O_WRONLY | O_APPEND | O_CLOEXEC, 0600);
        dup2(file, STDERR_FILENO);
        close(file);
    }
    ~StderrInFile() {
        dup2(saved_, STDERR_FILENO);
        close(saved_);
    }
    StderrInFile(const StderrInFile&) = delete;
    StderrInFile& operator=(const StderrInFile&) = delete;
    [[nodiscard]] bool holds(std::string_view text) const {
        std::ifstream file(path_);
        const std::string all{std::istreambuf_iterator<char>(file), {}};
        return all.find(text) != std::string::npos;
    }

private:
    fs::path path_;
    int saved_;
};

TEST_F(StatisticsUpdaterTest, TriesAgainWhenTheIndexWasBusy) {
    const StderrInFile written(folder_.path() / "log");
    server::Log log({.level = "error"});
    index::Searcher searcher = *index::Searcher::open(index_);
    index::Store store = open();
    index::Store impatient = open();
    ASSERT_TRUE(impatient.set_busy_timeout(20));
    ASSERT_TRUE(store.remove(1));
    auto lock = std::make_unique<HeldWriteLock>(index_);
    server::StatisticsUpdater updater(std::move(impatient), searcher, log);
    updater.request(When::kOutdated);
    ASSERT_TRUE(eventually([&] { return written.holds("index_busy"); }));
    EXPECT_FALSE(current(store));
    lock.reset();
    EXPECT_TRUE(eventually([&] { return current(store); }));
}

TEST_F(StatisticsUpdaterTest, AnswersARemovalBeforeTheStatisticsAreMade) {
    std::ofstream(folder_.path() / "key") << "a-key-for-tests-0123456789\n";
    const TestServer server(index_, [&](server::ServerOptions& options) {
        options.admin_key_file = folder_.path() / "key";
    });
    const std::string bearer = "Authorization: Bearer a-key-for-tests-0123456789\r\n";
    for (const char* id : {"1", "2", "3"}) {
        EXPECT_EQ(server.ask(request("DELETE", std::string("/v1/models/") + id, bearer)).status,
                  204);
        EXPECT_EQ(server.ask(get("/v1/models/6/similar")).status, 200);
    }
    index::Store store = open();
    EXPECT_TRUE(eventually([&] { return current(store); }));
    EXPECT_EQ(server.json(get("/v1/models/6/similar"))["models"], 3);
}

}  // namespace
}  // namespace ossuary::test
