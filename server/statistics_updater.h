#pragma once

#include <condition_variable>
#include <optional>
#include <stop_token>
#include <thread>

#include "engine/core/mutex.h"
#include "index/searcher.h"
#include "index/store.h"
#include "server/log.h"

namespace ossuary::server {

/// Keeps the collection's statistics up to date on a thread of its own, one computation at a time
/// on one processor and behind all requests. Requests that come meanwhile make one more. It rests
/// as long as it worked, so that a collection which changes all the time takes half a processor at
/// most. Answers use the statistics of before until then. What fails because the index
/// cannot be written for the moment is tried again. Ends within milliseconds when destroyed.
class StatisticsUpdater {
public:
    /// @param store  writable
    StatisticsUpdater(index::Store store, index::Searcher& searcher, Log& log);
    ~StatisticsUpdater();

    enum class When {
        kMissing,   ///< only where there are none
        kOutdated,  ///< where they are not those of the latest revision
    };
    /// Returns at once.
    void request(When when);

private:
    void work(const std::stop_token& stop);
    Result<void> update(When when, const std::stop_token& stop);
    void report(const Error& error);

    index::Store store_;
    index::Searcher& searcher_;
    Log& log_;
    Mutex mutex_;
    std::condition_variable_any requested_;
    std::optional<When> wanted_ OSSUARY_GUARDED_BY(mutex_);
    std::jthread thread_;  ///< last, so that it ends first
};

}  // namespace ossuary::server
