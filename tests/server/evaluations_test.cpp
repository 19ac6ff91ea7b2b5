#include "server/evaluations.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <new>
#include <stdexcept>
#include <vector>

#include "index/searcher.h"
#include "tests/server/test_server.h"

namespace ossuary::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using server::Evaluations;

class EvaluationsTest : public testing::Test {
protected:
    TemporaryFolder folder_;
    fs::path index_ = copy_of_built_index(folder_.path());
    index::Searcher searcher_ = *index::Searcher::open(index_);
    server::Log log_{{.level = "off"}};
    std::atomic<int> computed_ = 0;

    Evaluations::Snapshot snapshot() { return *searcher_.snapshot(); }

    /// What `compute` does at its n-th call, from 1; then it evaluates.
    using Prelude = std::function<void(int, const std::stop_token&)>;
    Evaluations::Compute compute(const Prelude& prelude) {
        return [this, prelude](const index::Snapshot& models,
                               const index::EvaluateOptions& options) -> Result<index::Evaluation> {
            prelude(++computed_, options.rank.stop);
            return index::evaluate(models, searcher_.stores(), options);
        };
    }
    /// Until the stop is requested.
    static void wait_for(const std::stop_token& stop) {
        while (!stop.stop_requested()) std::this_thread::sleep_for(1ms);
    }
};

TEST_F(EvaluationsTest, ComparesNoMorePairsThanAtTheLimitButAHundredQueries) {
    server::Evaluations evaluations(
        [](const index::Snapshot&, const index::EvaluateOptions&) -> Result<index::Evaluation> {
            return {ErrorCode::kInternal, "not asked"};
        },
        {.models = 1500}, log_);
    EXPECT_EQ(evaluations.sample_of(1500), 1500U);
    EXPECT_EQ(evaluations.sample_of(2000), 1125U);
    EXPECT_EQ(evaluations.sample_of(20000), 112U);
    EXPECT_EQ(evaluations.sample_of(1000000), 100U);
}

TEST_F(EvaluationsTest, EvaluatesOnceAndKeepsIt) {
    Evaluations evaluations(compute([](int, const auto&) {}), {}, log_);
    const auto first = evaluations.get(snapshot(), {}, {});
    ASSERT_TRUE(first && *first) << (*first).error().message;
    EXPECT_EQ((**first)->report.models, 6u);
    const auto second = evaluations.get(snapshot(), {}, {});
    EXPECT_EQ(**second, **first);
    EXPECT_EQ(*evaluations.peek(*snapshot(), {}), **first);
    EXPECT_EQ(computed_, 1);
}

TEST_F(EvaluationsTest, ForgetsWhatFailedAndTriesAgain) {
    const auto fails = [](int call, const auto&) {
        if (call == 1) throw std::bad_alloc();
        if (call == 2) throw std::runtime_error("a bug");
        if (call == 3) throw 7;
    };
    Evaluations evaluations(compute(fails), {}, log_);
    const ErrorCode expected[] = {ErrorCode::kOutOfMemory, ErrorCode::kInternal,
                                  ErrorCode::kInternal};
    for (const ErrorCode code : expected) {
        const auto answer = evaluations.get(snapshot(), {}, {});
        ASSERT_TRUE(answer && !*answer);
        EXPECT_EQ(answer->error().code, code);
        EXPECT_FALSE(evaluations.peek(*snapshot(), {}));
    }
    EXPECT_TRUE(evaluations.get(snapshot(), {}, {})->ok());
}

TEST_F(EvaluationsTest, GoesOnForTheNextRequestWhenOneHasNoTime) {
    std::atomic<bool> go_on = false;
    const auto waits = [&](int, const std::stop_token& stop) {
        while (!go_on && !stop.stop_requested()) std::this_thread::sleep_for(1ms);
    };
    Evaluations evaluations(compute(waits), {}, log_);
    std::stop_source hurried;
    hurried.request_stop();
    const auto cancelled = evaluations.get(snapshot(), {}, hurried.get_token());
    EXPECT_EQ(cancelled->error().code, ErrorCode::kCancelled);
    go_on = true;
    EXPECT_TRUE(evaluations.get(snapshot(), {}, {})->ok());
    EXPECT_EQ(computed_, 1);
}

TEST_F(EvaluationsTest, AnswersThoseWhoWaitForAnEarlierRevision) {
    std::atomic<bool> go_on = false;
    const auto waits = [&](int call, const std::stop_token& stop) {
        while (call == 1 && !go_on && !stop.stop_requested()) std::this_thread::sleep_for(1ms);
    };
    Evaluations evaluations(compute(waits), {}, log_);
    const auto old_one = snapshot();
    const ranking::RankOptions other{.ranker = ranking::RankerKind::kSkeleton};
    std::jthread first([&] { EXPECT_TRUE(evaluations.get(old_one, {}, {})->ok()); });
    std::jthread second([&] { EXPECT_TRUE(evaluations.get(old_one, other, {})->ok()); });
    while (computed_ == 0) std::this_thread::sleep_for(1ms);
    index_model(index_, "newcomer", built_models()[2].off + "# another file\n");
    const auto new_one = snapshot();
    ASSERT_GT(new_one->revision(), old_one->revision());
    std::jthread third([&] { EXPECT_TRUE(evaluations.get(new_one, {}, {})->ok()); });
    go_on = true;
    first.join();
    second.join();
    third.join();
    EXPECT_TRUE(evaluations.peek(*new_one, {}));
    EXPECT_FALSE(evaluations.peek(*old_one, {}));
}

TEST_F(EvaluationsTest, RefusesMoreThanSoManyWhoWait) {
    Evaluations evaluations(compute([](int, const auto& stop) { wait_for(stop); }), {.waiting = 2},
                            log_);
    std::stop_source enough;
    std::atomic<int> refused = 0, gave_up = 0;
    std::vector<std::jthread> waiting;
    for (int i = 0; i < 5; ++i) {
        waiting.emplace_back([&] {
            const auto answer = evaluations.get(snapshot(), {}, enough.get_token());
            ++(answer ? gave_up : refused);
        });
    }
    while (refused < 3) std::this_thread::sleep_for(1ms);
    enough.request_stop();
    waiting.clear();
    EXPECT_EQ(refused, 3);
    EXPECT_EQ(gave_up, 2);
}

TEST_F(EvaluationsTest, EndsWhatIsUnderWayWhenDestroyed) {
    auto evaluations = std::make_unique<Evaluations>(
        compute([](int, const auto& stop) { wait_for(stop); }), Evaluations::Limits{}, log_);
    std::stop_source hurried;
    hurried.request_stop();
    EXPECT_FALSE(evaluations->get(snapshot(), {}, hurried.get_token())->ok());
    while (computed_ == 0) std::this_thread::sleep_for(1ms);
    const auto start = std::chrono::steady_clock::now();
    evaluations.reset();
    EXPECT_LT(std::chrono::steady_clock::now() - start, 1s);
}

}  // namespace
}  // namespace ossuary::test
