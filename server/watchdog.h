#pragma once

#include <chrono>
#include <condition_variable>
#include <list>
#include <stop_token>
#include <thread>

#include "engine/core/mutex.h"
#include "server/connection.h"

namespace ossuary::server {

/// Asks requests to stop when their time is up or their client has closed its connection. One
/// thread looks after all of them.
class Watchdog {
    struct Entry {
        std::stop_source stop;
        Clock::time_point deadline;
        int socket = -1;
    };

public:
    Watchdog();
    ~Watchdog();
    Watchdog(const Watchdog&) = delete;
    Watchdog& operator=(const Watchdog&) = delete;

    /// One watched request; watched until destroyed.
    class Watch {
    public:
        Watch(Watchdog& owner, Clock::time_point deadline, int socket);
        ~Watch();
        Watch(const Watch&) = delete;
        Watch& operator=(const Watch&) = delete;
        [[nodiscard]] std::stop_token token() const { return entry_->stop.get_token(); }

    private:
        Watchdog& owner_;
        std::list<Entry>::iterator entry_;
    };

    /// Asks all that are watched now, and all to come, to stop.
    void stop_all();

private:
    void look(std::stop_token stop);

    Mutex mutex_;
    std::condition_variable_any changed_;
    std::list<Entry> entries_ OSSUARY_GUARDED_BY(mutex_);
    bool stop_all_ OSSUARY_GUARDED_BY(mutex_) = false;
    std::jthread thread_;  ///< last, so that it ends first
};

}  // namespace ossuary::server
