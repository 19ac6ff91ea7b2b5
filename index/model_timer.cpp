#include "index/model_timer.h"

#include <algorithm>

namespace ossuary::index {

namespace {
/// Longer limits mean the same and would not fit the clock.
constexpr std::chrono::duration<double> kLongest{1e9};
}  // namespace

ModelTimer::ModelTimer(double limit_seconds) : limit_(limit_seconds) {
    if (limit_seconds > 0.0) {
        thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
    }
}

void ModelTimer::run(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested()) {
        if (deadlines_.empty()) {
            changed_.wait(lock, stop, [this] { return !deadlines_.empty(); });
            continue;
        }
        const Clock::time_point first = deadlines_.begin()->first;
        changed_.wait_until(lock, stop, first, [&] {
            return deadlines_.empty() || deadlines_.begin()->first != first;
        });
        for (auto& [deadline, source] : deadlines_) {
            if (deadline > Clock::now()) break;
            source.request_stop();
        }
        // What was stopped stays listed until its worker notices; look again a little later.
        if (!deadlines_.empty() && deadlines_.begin()->first <= Clock::now()) {
            changed_.wait_for(lock, stop, std::chrono::milliseconds(50), [] { return false; });
        }
    }
}

ModelTimer::Watch::Watch(ModelTimer& timer, std::stop_token outer)
    : timer_(timer), forward_(std::move(outer), Forward{source_}) {
    const std::lock_guard lock(timer_.mutex_);
    const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                             std::min(timer_.limit_, kLongest));
    entry_ = timer_.deadlines_.emplace(deadline, source_);
    timer_.changed_.notify_one();
}

ModelTimer::Watch::~Watch() {
    const std::lock_guard lock(timer_.mutex_);
    timer_.deadlines_.erase(entry_);
    timer_.changed_.notify_one();
}

}  // namespace ossuary::index
