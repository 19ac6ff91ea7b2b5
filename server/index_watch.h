#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

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
    void look();

    index::Searcher& searcher_;
    Log& log_;
    std::uint64_t replacements_ = 0;
    std::string last_error_;
    std::mutex mutex_;
    std::condition_variable_any wake_;
    std::jthread thread_;  ///< last, so that it ends first
};

}  // namespace ossuary::server
