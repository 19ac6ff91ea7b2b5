#include "engine/core/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

namespace ossuary {
namespace {

TEST(ParallelFor, VisitsEachIndexOnceWhateverTheJobs) {
    for (const int jobs : {1, 2, 3, 8, 0}) {
        for (const std::size_t count : {0u, 1u, 2u, 1000u}) {
            std::vector<std::atomic<int>> visits(count);
            parallel_for(count, jobs, [&](std::size_t i) { ++visits[i]; });
            for (const auto& visited : visits) EXPECT_EQ(visited.load(), 1);
        }
    }
}

TEST(ParallelFor, GoesThroughTheIndicesInOrderOnOneJob) {
    std::vector<std::size_t> order;
    parallel_for(100, 1, [&](std::size_t i) { order.push_back(i); });
    ASSERT_EQ(order.size(), 100u);
    for (std::size_t i = 0; i < 100; ++i) EXPECT_EQ(order[i], i);
}

TEST(ParallelFor, NeverUsesMoreThreadsThanJobs) {
    std::mutex mutex;
    std::set<std::thread::id> threads;
    parallel_for(200, 2, [&](std::size_t) {
        std::this_thread::sleep_for(std::chrono::microseconds(50));
        const std::lock_guard lock(mutex);
        threads.insert(std::this_thread::get_id());
    });
    EXPECT_GE(threads.size(), 1u);
    EXPECT_LE(threads.size(), 2u);
}

TEST(ParallelFor, CanBeNested) {
    std::atomic<int> visits = 0;
    parallel_for(8, 2, [&](std::size_t) { parallel_for(8, 2, [&](std::size_t) { ++visits; }); });
    EXPECT_EQ(visits.load(), 64);
}

TEST(ResolveJobs, TakesZeroForAllThreads) {
    EXPECT_GE(resolve_jobs(0), 1);
    EXPECT_EQ(resolve_jobs(1), 1);
    EXPECT_EQ(resolve_jobs(7), 7);
}

}  // namespace
}  // namespace ossuary
