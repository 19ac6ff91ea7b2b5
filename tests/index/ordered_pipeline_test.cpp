#include "index/ordered_pipeline.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>

#include "index/model_timer.h"

namespace ossuary::index {
namespace {

using namespace std::chrono_literals;

TEST(RunInOrder, ConsumesInOrderWhateverTakesLong) {
    for (const int jobs : {1, 4}) {
        std::vector<std::size_t> seen;
        run_in_order<std::size_t>(
            50, jobs, 8,
            [](std::size_t i) {
                if (i % 7 == 0) std::this_thread::sleep_for(2ms);
                return i * i;
            },
            [&](std::size_t i, std::size_t square) {
                EXPECT_EQ(square, i * i);
                seen.push_back(i);
                return true;
            });
        ASSERT_EQ(seen.size(), 50U);
        for (std::size_t i = 0; i < seen.size(); ++i) EXPECT_EQ(seen[i], i);
    }
}

TEST(RunInOrder, NeverRunsAheadOfTheWindow) {
    std::atomic<std::size_t> consumed = 0;
    std::atomic<std::size_t> too_far = 0;
    run_in_order<int>(
        40, 4, 5,
        [&](std::size_t i) {
            // `consumed` is counted before the window moves on, so never behind it.
            if (i >= consumed + 5) ++too_far;
            if (i == 0) std::this_thread::sleep_for(20ms);
            return 0;
        },
        [&](std::size_t, int) {
            ++consumed;
            return true;
        });
    EXPECT_EQ(too_far, 0U);
    EXPECT_EQ(consumed, 40U);
}

TEST(RunInOrder, BeginsNothingAfterTheConsumerHasEnough) {
    std::atomic<int> begun = 0;
    int consumed = 0;
    run_in_order<int>(
        1000, 3, 10,
        [&](std::size_t) {
            ++begun;
            return 0;
        },
        [&](std::size_t i, int) {
            ++consumed;
            return i < 4;
        });
    EXPECT_EQ(consumed, 5);
    EXPECT_LE(begun, 5 + 10);
}

TEST(RunInOrder, DoesNothingForNothing) {
    run_in_order<int>(
        0, 3, 10, [](std::size_t) { return 0; },
        [](std::size_t, int) {
            ADD_FAILURE();
            return true;
        });
}

TEST(ModelTimer, StopsWhatTakesTooLongAndNothingElse) {
    ModelTimer timer(0.02);
    std::stop_source outer;
    const ModelTimer::Watch slow(timer, outer.get_token());
    const auto begin = std::chrono::steady_clock::now();
    while (!slow.token().stop_requested() && std::chrono::steady_clock::now() - begin < 10s) {
        std::this_thread::sleep_for(1ms);
    }
    EXPECT_TRUE(slow.token().stop_requested());
    EXPECT_FALSE(outer.stop_requested());

    ModelTimer patient(3600.0);
    const ModelTimer::Watch quick(patient, outer.get_token());
    std::this_thread::sleep_for(5ms);
    EXPECT_FALSE(quick.token().stop_requested());
    outer.request_stop();
    EXPECT_TRUE(quick.token().stop_requested()) << "a stop of everything stops each";
}

TEST(ModelTimer, WithoutALimitNeverStopsOfItsOwn) {
    ModelTimer timer(0.0);
    const ModelTimer::Watch watch(timer, {});
    std::this_thread::sleep_for(5ms);
    EXPECT_FALSE(watch.token().stop_requested());
}

}  // namespace
}  // namespace ossuary::index
