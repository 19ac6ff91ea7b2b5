#pragma once

#include <httplib.h>

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace ossuary::server {

/// Threads that take accepted connections in turn. `enqueue` runs a task at once, on the accepting
/// thread, when too many wait; `Acceptor` then turns that connection away.
class HttpWorkers : public httplib::TaskQueue {
public:
    HttpWorkers(int threads, std::size_t max_waiting, std::atomic<std::size_t>& waiting)
        : max_waiting_(max_waiting), waiting_(waiting) {
        for (int i = 0; i < threads; ++i) threads_.emplace_back([this] { work(); });
    }

    void enqueue(std::function<void()> task) override {
        {
            std::unique_lock lock(mutex_);
            if (tasks_.size() < max_waiting_) {
                tasks_.push_back(std::move(task));
                waiting_ = tasks_.size() > idle_ ? tasks_.size() - idle_ : 0;
                lock.unlock();
                wake_.notify_one();
                return;
            }
        }
        task();
    }

    void shutdown() override {
        {
            std::lock_guard lock(mutex_);
            ending_ = true;
        }
        wake_.notify_all();
        for (std::thread& thread : threads_) thread.join();
    }

private:
    void work() {
        while (true) {
            std::function<void()> task;
            {
                std::unique_lock lock(mutex_);
                ++idle_;
                wake_.wait(lock, [this] { return ending_ || !tasks_.empty(); });
                --idle_;
                if (tasks_.empty()) return;
                task = std::move(tasks_.front());
                tasks_.pop_front();
                waiting_ = tasks_.size() > idle_ ? tasks_.size() - idle_ : 0;
            }
            task();
        }
    }

    const std::size_t max_waiting_;
    std::atomic<std::size_t>& waiting_;  ///< connections that no idle thread will take
    std::mutex mutex_;
    std::condition_variable wake_;
    std::deque<std::function<void()>> tasks_;
    std::size_t idle_ = 0;
    bool ending_ = false;
    std::vector<std::thread> threads_;
};

}  // namespace ossuary::server
