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
    Lock lock(mutex_);
    // The earliest not stopped yet; what was stopped stays listed until its worker leaves.
    const auto pending = [this]() OSSUARY_REQUIRES(mutex_) {
        return std::find_if(deadlines_.begin(), deadlines_.end(),
                            [](const auto& entry) { return !entry.second.stop_requested(); });
    };
    while (!stop.stop_requested()) {
        const auto next = pending();
        if (next == deadlines_.end()) {
            changed_.wait(lock, stop,
                          [&]() OSSUARY_REQUIRES(mutex_) { return pending() != deadlines_.end(); });
            continue;
        }
        const Clock::time_point first = next->first;
        changed_.wait_until(lock, stop, first, [&]() OSSUARY_REQUIRES(mutex_) {
            const auto now_next = pending();
            return now_next == deadlines_.end() || now_next->first != first;
        });
        for (auto& [deadline, source] : deadlines_) {
            if (deadline > Clock::now()) break;
            source.request_stop();
        }
    }
}

ModelTimer::Watch::Watch(ModelTimer& timer, std::stop_token outer)
    : timer_(timer), forward_(std::move(outer), Forward{source_}) {
    const Lock lock(timer_.mutex_);
    const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                             std::min(timer_.limit_, kLongest));
    entry_ = timer_.deadlines_.emplace(deadline, source_);
    timer_.changed_.notify_one();
}

ModelTimer::Watch::~Watch() {
    const Lock lock(timer_.mutex_);
    timer_.deadlines_.erase(entry_);
    timer_.changed_.notify_one();
}

}  // namespace ossuary::index
