#pragma once

#include <algorithm>
#include <cassert>
#include <condition_variable>
#include <cstddef>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace ossuary::index {

/// Calls `produce(i)` for i in [0, count) on `jobs` threads of its own, and `consume(i, outcome)`
/// on the calling thread in the order of i. At most `window` outcomes wait for their turn, which
/// bounds memory however uneven the work is. When `consume` returns false nothing further is begun
/// and what is under way is thrown away. Neither may throw.
template <typename Outcome, typename Produce, typename Consume>
void run_in_order(std::size_t count, int jobs, std::size_t window, const Produce& produce,
                  const Consume& consume) {
    assert(jobs > 0 && window > 0);
    std::mutex mutex;
    std::condition_variable room;     // for workers: the window moved on, or the end
    std::condition_variable arrived;  // for the consumer
    std::map<std::size_t, Outcome> waiting;
    std::size_t next_begun = 0;
    std::size_t next_consumed = 0;
    bool stopped = false;

    const auto work = [&] {
        std::unique_lock lock(mutex);
        while (true) {
            room.wait(lock, [&] {
                return stopped || next_begun >= count || next_begun < next_consumed + window;
            });
            if (stopped || next_begun >= count) return;
            const std::size_t i = next_begun++;
            lock.unlock();
            Outcome outcome = produce(i);
            lock.lock();
            waiting.emplace(i, std::move(outcome));
            if (i == next_consumed) arrived.notify_one();
        }
    };
    std::vector<std::jthread> workers;
    const std::size_t worker_count = std::min(count, static_cast<std::size_t>(jobs));
    for (std::size_t i = 0; i < worker_count; ++i) workers.emplace_back(work);

    std::unique_lock lock(mutex);
    while (next_consumed < count && !stopped) {
        arrived.wait(lock, [&] { return waiting.contains(next_consumed); });
        auto node = waiting.extract(next_consumed);
        const std::size_t i = next_consumed;
        lock.unlock();
        const bool go_on = consume(i, std::move(node.mapped()));
        lock.lock();
        ++next_consumed;
        stopped = !go_on;
        room.notify_all();
    }
    lock.unlock();
}

}  // namespace ossuary::index
