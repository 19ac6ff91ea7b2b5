#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

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
    [[nodiscard]] Task next(bool urgent_alone);

    const std::size_t max_waiting_;
    std::mutex mutex_;
    std::condition_variable added_;         ///< for threads that take anything
    std::condition_variable urgent_added_;  ///< for the one that takes urgent ones alone
    std::deque<Task> urgent_;
    std::deque<Task> waiting_;
    std::size_t idle_;  ///< threads that take anything and have no task, started or not
    bool ending_ = false;
    std::vector<std::jthread> threads_;  ///< last, so that they end first
};

}  // namespace ossuary::server
