#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <thread>
#include <vector>

#include "engine/core/mutex.h"

namespace ossuary::server {

/// Threads that take tasks in turn, and one more that takes urgent ones alone, so that those are
/// done while all others are busy.
class HttpWorkers {
public:
    /// No exception may leave it.
    using Task = std::function<void()>;

    HttpWorkers(int threads, std::size_t max_waiting);
    /// Works off what waits.
    ~HttpWorkers();
    HttpWorkers(const HttpWorkers&) = delete;
    HttpWorkers& operator=(const HttpWorkers&) = delete;

    /// False when too many wait.
    [[nodiscard]] bool enqueue(Task task, bool urgent);

private:
    void work(bool urgent_alone);
    [[nodiscard]] Task next(bool urgent_alone) OSSUARY_REQUIRES(mutex_);

    const std::size_t max_waiting_;
    Mutex mutex_;
    std::condition_variable_any added_;         ///< for threads that take anything
    std::condition_variable_any urgent_added_;  ///< for the one that takes urgent ones alone
    std::deque<Task> urgent_ OSSUARY_GUARDED_BY(mutex_);
    std::deque<Task> waiting_ OSSUARY_GUARDED_BY(mutex_);
    /// Threads that take anything and have no task, started or not.
    std::size_t idle_ OSSUARY_GUARDED_BY(mutex_);
    bool ending_ OSSUARY_GUARDED_BY(mutex_) = false;
    std::vector<std::jthread> threads_;  ///< last, so that they end first
};

}  // namespace ossuary::server
