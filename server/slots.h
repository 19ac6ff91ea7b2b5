#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <optional>
#include <stop_token>
#include <utility>

#include "engine/core/mutex.h"

namespace ossuary::server {

/// So many pieces of heavy work at once, so many more waiting, and no more than that.
class Slots {
public:
    Slots(std::size_t slots, std::size_t max_waiting) : free_(slots), max_waiting_(max_waiting) {}

    /// One slot, given back when destroyed.
    class Hold {
    public:
        explicit Hold(Slots& owner) : owner_(&owner) {}
        Hold(Hold&& other) noexcept : owner_(std::exchange(other.owner_, nullptr)) {}
        Hold& operator=(Hold&&) = delete;
        ~Hold() {
            if (owner_ != nullptr) owner_->give_back();
        }

    private:
        Slots* owner_;
    };

    enum class Refusal { kFull, kStopped };
    struct Outcome {
        std::optional<Hold> hold;
        Refusal refusal = Refusal::kFull;  ///< where there is no hold
    };
    /// Waits for a slot; refused at once when too many wait, and when `stop` is requested.
    Outcome acquire(std::stop_token stop);

    /// Whether `acquire` would refuse now; for turning requests away before their body is read.
    [[nodiscard]] bool full() const;
    [[nodiscard]] std::size_t waiting() const;

private:
    void give_back();

    mutable Mutex mutex_;
    std::condition_variable_any freed_;
    std::size_t free_ OSSUARY_GUARDED_BY(mutex_);
    const std::size_t max_waiting_;
    std::size_t waiting_ OSSUARY_GUARDED_BY(mutex_) = 0;
};

}  // namespace ossuary::server
