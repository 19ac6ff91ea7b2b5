// Small versions of the worst cases (tests/support/worst_cases.h) through everything that is done
// to a model, and stopped at random moments of it.
#include <gtest/gtest.h>

#include <time.h>

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <random>
#include <stop_token>
#include <thread>

#include "engine/decomposition/decompose.h"
#include "engine/descriptor/describe.h"
#include "engine/mesh/write_mesh.h"
#include "index/describe_model.h"
#include "tests/support/random.h"
#include "tests/support/worst_cases.h"

namespace ossuary {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

/// What all threads of this program have taken: the same however busy the machine is.
Seconds processor_time() {
    timespec taken{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &taken);
    return std::chrono::seconds(taken.tv_sec) + std::chrono::nanoseconds(taken.tv_nsec);
}

/// What may be said of a model that cannot be used; anything else is a fault of ours.
bool is_refusal(ErrorCode code) {
    return code == ErrorCode::kSolidEmpty || code == ErrorCode::kMeshEmpty ||
           code == ErrorCode::kMeshNoExtent;
}

class WorstCases : public testing::TestWithParam<test::WorstCase> {
protected:
    mesh::TriangleMesh mesh_ = GetParam().build(GetParam().small);
};

TEST_P(WorstCases, AreDescribed) {
    const auto described = descriptor::describe(mesh_);
    if (!described) {
        EXPECT_TRUE(is_refusal(described.error().code)) << described.error().message;
        return;
    }
    EXPECT_FALSE(described->skeleton.empty());
    for (const auto& node : described->skeleton.nodes) {
        EXPECT_TRUE(node.position.allFinite());
        EXPECT_TRUE(std::isfinite(node.significance));
    }
}

TEST_P(WorstCases, AreCutIntoParts) {
    const auto parts = decomposition::decompose(mesh_);
    if (!parts) {
        EXPECT_TRUE(is_refusal(parts.error().code)) << parts.error().message;
        return;
    }
    EXPECT_EQ(parts->segmentation.labels.size(), mesh_.triangles.size());
    EXPECT_GE(parts->segmentation.parts, 1u);
}

/// Requests a stop after a while, unless it is no longer needed.
class StopAfter {
public:
    StopAfter(Seconds delay, std::stop_source& source)
        : thread_([this, delay, &source](const std::stop_token& unneeded) {
              std::unique_lock lock(mutex_);
              changed_.wait_for(lock, unneeded, delay, [] { return false; });
              asked_at_ = processor_time();
              source.request_stop();
          }) {}

    /// The processor time when the stop was requested.
    Seconds asked_at() {
        thread_.request_stop();
        thread_.join();
        return asked_at_;
    }

private:
    std::mutex mutex_;
    std::condition_variable_any changed_;
    Seconds asked_at_{};
    std::jthread thread_;
};

/// Stops `work`, which takes `whole` undisturbed, at moments all over it: it returns soon, and says
/// that it was cancelled unless it had finished. Returns how often it was stopped.
int stop_at_many_moments(
    Seconds whole, const std::function<std::optional<ErrorCode>(const std::stop_token&)>& work) {
    // What is promised of models of any size; small ones take a hundredth of it on an idle machine.
    constexpr Seconds kSoon(1.0);
    constexpr int kMoments = 8;
    std::mt19937_64 random(1);
    // Once before it begins: what takes a millisecond may be over before any later stop.
    std::stop_source before;
    before.request_stop();
    int cancelled = work(before.get_token()) == ErrorCode::kCancelled ? 1 : 0;
    for (int i = 0; i < kMoments; ++i) {
        std::stop_source source;
        StopAfter stopper(whole * test::next_unit(random), source);
        const std::optional<ErrorCode> error = work(source.get_token());
        const Seconds returned_at = processor_time();
        EXPECT_LT((returned_at - stopper.asked_at()).count(), kSoon.count());
        if (!error) continue;
        EXPECT_TRUE(*error == ErrorCode::kCancelled || is_refusal(*error)) << to_string(*error);
        cancelled += *error == ErrorCode::kCancelled ? 1 : 0;
    }
    return cancelled;
}

TEST_P(WorstCases, StopWithinASecond) {
    const std::string bytes = mesh::to_off(mesh_);
    const auto work = [&](const std::stop_token& stop) -> std::optional<ErrorCode> {
        const auto model = index::describe_model({bytes, "model.off"}, {}, stop);
        if (model) return std::nullopt;
        return model.error().code;
    };
    const auto begin = Clock::now();
    work({});
    EXPECT_GT(stop_at_many_moments(Clock::now() - begin, work), 0);
}

TEST_P(WorstCases, StopWithinASecondWhenCutIntoParts) {
    const auto work = [&](const std::stop_token& stop) -> std::optional<ErrorCode> {
        const auto parts = decomposition::decompose(mesh_, {}, stop);
        if (parts) return std::nullopt;
        return parts.error().code;
    };
    const auto begin = Clock::now();
    work({});
    EXPECT_GT(stop_at_many_moments(Clock::now() - begin, work), 0);
}

INSTANTIATE_TEST_SUITE_P(All, WorstCases,
                         testing::ValuesIn(test::worst_cases().begin(), test::worst_cases().end()),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace

namespace test {
/// How GoogleTest writes the cases in its messages.
void PrintTo(const WorstCase& worst, std::ostream* out);
void PrintTo(const WorstCase& worst, std::ostream* out) { *out << worst.name; }
}  // namespace test
}  // namespace ossuary
