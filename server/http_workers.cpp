#include "server/http_workers.h"

#include <utility>

namespace ossuary::server {
namespace {

constexpr std::size_t kMostUrgent = 64;

}  // namespace

HttpWorkers::HttpWorkers(int threads, std::size_t max_waiting)
    : max_waiting_(max_waiting), idle_(static_cast<std::size_t>(threads)) {
    for (int i = 0; i < threads; ++i) threads_.emplace_back([this] { work(false); });
    threads_.emplace_back([this] { work(true); });
}

HttpWorkers::~HttpWorkers() {
    {
        const Lock lock(mutex_);
        ending_ = true;
    }
    added_.notify_all();
    urgent_added_.notify_all();
}

bool HttpWorkers::enqueue(Task task, bool urgent) {
    {
        const Lock lock(mutex_);
        auto& queue = urgent ? urgent_ : waiting_;
        if (queue.size() >= (urgent ? kMostUrgent : max_waiting_ + idle_)) return false;
        queue.push_back(std::move(task));
    }
    added_.notify_one();
    if (urgent) urgent_added_.notify_one();
    return true;
}

HttpWorkers::Task HttpWorkers::next(bool urgent_alone) {
    for (auto* queue : {&urgent_, &waiting_}) {
        if (queue->empty() || (urgent_alone && queue == &waiting_)) continue;
        Task task = std::move(queue->front());
        queue->pop_front();
        return task;
    }
    return {};
}

void HttpWorkers::work(bool urgent_alone) {
    Lock lock(mutex_);
    while (true) {
        if (const Task task = next(urgent_alone)) {
            if (!urgent_alone) --idle_;
            lock.unlock();
            task();
            lock.lock();
            if (!urgent_alone) ++idle_;
        } else if (ending_) {
            return;
        } else if (urgent_alone) {
            urgent_added_.wait(lock);
        } else {
            added_.wait(lock);
        }
    }
}

}  // namespace ossuary::server
