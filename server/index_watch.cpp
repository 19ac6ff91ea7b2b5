#include "server/index_watch.h"

#include <chrono>

#include "server/without_exceptions.h"

namespace ossuary::server {

IndexWatch::IndexWatch(index::Searcher& searcher, Log& log)
    : searcher_(searcher), log_(log), thread_([this](std::stop_token stop) { work(stop); }) {}

void IndexWatch::work(std::stop_token stop) {
    using namespace std::chrono_literals;
    Lock lock(mutex_);
    while (!wake_.wait_for(lock, stop, 1s, [] { return false; }) && !stop.stop_requested()) {
        const auto looked = without_exceptions([this] { return look(); });
        if (looked) {
            if (!last_error_.empty()) log_.info("index: it can be used again");
            last_error_.clear();
            continue;
        }
        const std::string error =
            std::string(to_string(looked.error().code)) + ": " + looked.error().message;
        if (error != last_error_) log_.error("index: " + error);
        last_error_ = error;
    }
}

Result<void> IndexWatch::look() {
    const auto state = searcher_.store().collection_state();
    if (!state) return state.error();
    if (state->replacements == replacements_) return {};
    replacements_ = state->replacements;
    log_.warn("index: another file has taken its place and is served from now on, revision " +
              std::to_string(state->models));
    return {};
}

}  // namespace ossuary::server
