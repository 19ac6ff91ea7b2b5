#pragma once

#include <chrono>
#include <condition_variable>
#include <map>
#include <stop_token>
#include <thread>

#include "engine/core/mutex.h"

namespace ossuary::index {

/// Requests a stop of whatever takes longer than it may. One thread watches over any number of
/// workers.
class ModelTimer {
public:
    /// @param limit_seconds  0 = no limit
    explicit ModelTimer(double limit_seconds);

    /// One piece of work, from construction to destruction; stops when its time is over or when
    /// `outer` asks for it.
    class Watch {
    public:
        Watch(ModelTimer& timer, std::stop_token outer);
        ~Watch();
        Watch(const Watch&) = delete;
        Watch& operator=(const Watch&) = delete;
        [[nodiscard]] std::stop_token token() const { return source_.get_token(); }

    private:
        struct Forward {
            std::stop_source& source;
            void operator()() const { source.request_stop(); }
        };
        ModelTimer& timer_;
        std::stop_source source_;
        std::stop_callback<Forward> forward_;
        std::multimap<std::chrono::steady_clock::time_point, std::stop_source>::iterator entry_;
    };

private:
    using Clock = std::chrono::steady_clock;
    void run(const std::stop_token& stop);

    std::chrono::duration<double> limit_;
    Mutex mutex_;
    std::condition_variable_any changed_;
    std::multimap<Clock::time_point, std::stop_source> deadlines_ OSSUARY_GUARDED_BY(mutex_);
    std::jthread thread_;  ///< last, so that it ends before what it uses
};

}  // namespace ossuary::index
