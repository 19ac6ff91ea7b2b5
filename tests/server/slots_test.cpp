#include "server/slots.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>
#include <vector>

namespace ossuary::server {
namespace {

TEST(Slots, NeverLetInMoreThanThereAre) {
    Slots slots(3, 1000);
    std::atomic<int> inside = 0;
    std::atomic<int> most = 0;
    std::atomic<int> done = 0;
    {
        std::vector<std::jthread> threads;
        for (int i = 0; i < 16; ++i) {
            threads.emplace_back([&] {
                for (int k = 0; k < 50; ++k) {
                    const auto outcome = slots.acquire({});
                    ASSERT_TRUE(outcome.hold);
                    const int now = ++inside;
                    int seen = most;
                    while (now > seen && !most.compare_exchange_weak(seen, now)) {
                    }
                    std::this_thread::yield();
                    --inside;
                    ++done;
                }
            });
        }
    }
    EXPECT_EQ(done, 16 * 50);
    EXPECT_LE(most, 3);
    EXPECT_GE(most, 1);
}

TEST(Slots, RefuseWhenTooManyWait) {
    Slots slots(1, 0);
    const auto first = slots.acquire({});
    ASSERT_TRUE(first.hold);
    EXPECT_TRUE(slots.full());
    const auto second = slots.acquire({});
    EXPECT_FALSE(second.hold);
    EXPECT_EQ(second.refusal, Slots::Refusal::kFull);
}

TEST(Slots, StopWaitingWhenAsked) {
    Slots slots(1, 1);
    const auto first = slots.acquire({});
    std::stop_source stop;
    std::jthread later([&] {
        while (slots.waiting() == 0) std::this_thread::yield();
        stop.request_stop();
    });
    const auto second = slots.acquire(stop.get_token());
    EXPECT_FALSE(second.hold);
    EXPECT_EQ(second.refusal, Slots::Refusal::kStopped);
    EXPECT_EQ(slots.waiting(), 0u);
}

}  // namespace
}  // namespace ossuary::server
