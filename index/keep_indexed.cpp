#include "index/keep_indexed.h"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <utility>

namespace ossuary::index {

namespace {

namespace fs = std::filesystem;

void sleep_for(std::chrono::milliseconds time, const std::stop_token& stop) {
    std::mutex mutex;
    std::condition_variable_any never;
    std::unique_lock lock(mutex);
    never.wait_for(lock, stop, time, [] { return false; });
}

/// The runs, and what has been told of them.
class Keeper {
public:
    Keeper(Store& store, const IndexOptions& indexing, const KeepOptions& options, KeepSink& sink,
           const std::stop_token& stop)
        : store_(store), indexing_(indexing), options_(options), sink_(sink), stop_(stop) {}

    Result<void> run() {
        auto watch = FolderWatch::open(indexing_.paths, options_.folders);
        if (!watch) return watch.error();
        while (!stop_.stop_requested()) {
            watch->refresh(stop_);
            tell_untold(watch->untold());
            if (!bring_up_to_date()) {
                sleep_for(options_.retry, stop_);
            } else if (watch->wait(stop_) == FolderWatch::Reason::kStop) {
                break;
            }
        }
        return {};
    }

private:
    /// False where it is to be tried again soon.
    bool bring_up_to_date() {
        std::vector<fs::path> missing;
        for (const fs::path& path : indexing_.paths) {
            std::error_code fault;
            if (!fs::exists(path, fault)) missing.push_back(path);
        }
        if (missing != missing_) sink_.missing(missing);
        missing_ = missing;
        auto outcome = index_models(store_, indexing_, sink_, stop_);
        // A path that has never been there is an error of the run; others then go on without it.
        if (!outcome && outcome.error().code == ErrorCode::kFileNotFound && !missing.empty()) {
            IndexOptions there = indexing_;
            std::erase_if(there.paths, [&](const fs::path& path) {
                return std::ranges::find(missing, path) != missing.end();
            });
            if (there.paths.empty()) return true;
            outcome = index_models(store_, there, sink_, stop_);
        }
        if (outcome) {
            sink_.ran(*outcome);
        } else if (!stop_.stop_requested()) {
            sink_.run_failed(outcome.error());
        }
        return outcome.ok();
    }

    void tell_untold(const std::vector<fs::path>& folders) {
        if (folders == untold_) return;
        sink_.untold(folders);
        untold_ = folders;
    }

    Store& store_;
    const IndexOptions& indexing_;
    const KeepOptions& options_;
    KeepSink& sink_;
    const std::stop_token& stop_;
    std::vector<fs::path> missing_, untold_;
};

}  // namespace

Result<void> keep_indexed(Store& store, const IndexOptions& indexing, const KeepOptions& options,
                          KeepSink& sink, const std::stop_token& stop) {
    return Keeper(store, indexing, options, sink, stop).run();
}

}  // namespace ossuary::index
