#include "server/slots.h"

namespace ossuary::server {

Slots::Outcome Slots::acquire(std::stop_token stop) {
    Lock lock(mutex_);
    if (free_ == 0) {
        if (waiting_ >= max_waiting_) return {std::nullopt, Refusal::kFull};
        ++waiting_;
        const bool got =
            freed_.wait(lock, stop, [this]() OSSUARY_REQUIRES(mutex_) { return free_ > 0; });
        --waiting_;
        if (!got) return {std::nullopt, Refusal::kStopped};
    }
    --free_;
    Outcome outcome;
    outcome.hold.emplace(*this);
    return outcome;
}

bool Slots::full() const {
    const Lock lock(mutex_);
    return free_ == 0 && waiting_ >= max_waiting_;
}

std::size_t Slots::waiting() const {
    const Lock lock(mutex_);
    return waiting_;
}

void Slots::give_back() {
    {
        const Lock lock(mutex_);
        ++free_;
    }
    freed_.notify_one();
}

}  // namespace ossuary::server
