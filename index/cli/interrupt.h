#pragma once

#include <stop_token>
#include <thread>

namespace ossuary::cli {

/// While it lives, the first SIGINT or SIGTERM requests a stop, so that a command can end between
/// two models with everything stored; a second one ends the program at once.
class InterruptGuard {
public:
    InterruptGuard();
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;

    [[nodiscard]] std::stop_token stop_token() const { return source_.get_token(); }

private:
    std::stop_source source_;
    std::thread waiter_;
};

}  // namespace ossuary::cli
