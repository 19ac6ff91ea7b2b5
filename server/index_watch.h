#pragma once

#include <condition_variable>
#include <cstdint>
#include <stop_token>
#include <string>
#include <thread>

#include "engine/core/mutex.h"
#include "index/searcher.h"
#include "server/log.h"

namespace ossuary::server {

/// Looks once a second whether another file has taken the index's place, also while nobody asks for
/// anything: until the server has let go of the old file, nobody may use the new one. Says in the
/// log what it sees.
class IndexWatch {
public:
    IndexWatch(index::Searcher& searcher, Log& log);

private:
    void work(std::stop_token stop);
    Result<void> look();

    index::Searcher& searcher_;
    Log& log_;
    std::uint64_t replacements_ = 0;
    std::string last_error_;
    Mutex mutex_;  ///< for waiting alone: the rest belongs to the thread
    std::condition_variable_any wake_;
    std::jthread thread_;  ///< last, so that it ends first
};

}  // namespace ossuary::server
