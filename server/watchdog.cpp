#include "server/watchdog.h"

#include <poll.h>

namespace ossuary::server {
namespace {

constexpr auto kPeriod = std::chrono::milliseconds(50);

bool peer_has_closed(int socket) {
    pollfd entry{socket, POLLRDHUP, 0};
    return poll(&entry, 1, 0) > 0 && (entry.revents & (POLLRDHUP | POLLHUP | POLLERR)) != 0;
}

}  // namespace

Watchdog::Watchdog() : thread_([this](std::stop_token stop) { look(stop); }) {}

Watchdog::~Watchdog() = default;

Watchdog::Watch::Watch(Watchdog& owner, Clock::time_point deadline, int socket) : owner_(owner) {
    const Lock lock(owner_.mutex_);
    owner_.entries_.push_front({std::stop_source(), deadline, socket});
    entry_ = owner_.entries_.begin();
    if (owner_.stop_all_) entry_->stop.request_stop();
    owner_.changed_.notify_all();
}

Watchdog::Watch::~Watch() {
    const Lock lock(owner_.mutex_);
    owner_.entries_.erase(entry_);
}

void Watchdog::stop_all() {
    const Lock lock(mutex_);
    stop_all_ = true;
    for (Entry& entry : entries_) entry.stop.request_stop();
}

void Watchdog::look(std::stop_token stop) {
    Lock lock(mutex_);
    while (!stop.stop_requested()) {
        // Sleeps for good while nothing is going on, and in short steps otherwise.
        const auto any = [this]() OSSUARY_REQUIRES(mutex_) { return !entries_.empty(); };
        if (!changed_.wait(lock, stop, any)) return;
        const auto now = Clock::now();
        for (Entry& entry : entries_) {
            if (entry.stop.stop_requested()) continue;
            if (now >= entry.deadline || peer_has_closed(entry.socket)) entry.stop.request_stop();
        }
        changed_.wait_for(lock, stop, kPeriod, [] { return false; });
    }
}

}  // namespace ossuary::server
