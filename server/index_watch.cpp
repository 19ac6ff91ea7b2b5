#include "server/index_watch.h"

#include <chrono>
#include <exception>

namespace ossuary::server {

IndexWatch::IndexWatch(index::Searcher& searcher, Log& log)
    : searcher_(searcher), log_(log), thread_([this](std::stop_token stop) { work(stop); }) {}

void IndexWatch::work(std::stop_token stop) {
    using namespace std::chrono_literals;
    std::unique_lock lock(mutex_);
    while (!wake_.wait_for(lock, stop, 1s, [] { return false; }) && !stop.stop_requested()) {
        try {
            look();
        } catch (const std::exception& exception) {
            log_.error(std::string("index: ") + exception.what());
        }
    }
}

void IndexWatch::look() {
    const auto state = searcher_.store().collection_state();
    if (!state) {
        const std::string error =
            std::string(to_string(state.error().code)) + ": " + state.error().message;
        if (error != last_error_) log_.error("index: " + error);
        last_error_ = error;
        return;
    }
    if (!last_error_.empty()) log_.info("index: it can be used again");
    last_error_.clear();
    if (state->replacements == replacements_) return;
    replacements_ = state->replacements;
    log_.warn("index: another file has taken its place and is served from now on, revision " +
              std::to_string(state->models));
}

}  // namespace ossuary::server
