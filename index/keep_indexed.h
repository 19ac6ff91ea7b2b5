#pragma once

#include <chrono>
#include <filesystem>
#include <stop_token>
#include <vector>

#include "engine/core/result.h"
#include "index/folder_watch.h"
#include "index/indexer.h"
#include "index/store.h"

namespace ossuary::index {

struct KeepOptions {
    FolderWatchOptions folders;
    /// After a run that failed, until the next.
    std::chrono::milliseconds retry{10'000};
};

/// Hears of the runs; called from one thread.
class KeepSink : public ProgressSink {
public:
    /// A run is over. Those in which nothing changed are told, too.
    virtual void ran(const IndexOutcome& outcome) = 0;
    /// A run failed as a whole; there will be another.
    virtual void run_failed(const Error& error) = 0;
    /// What of the paths is not there; told when it changes.
    virtual void missing(const std::vector<std::filesystem::path>& paths) = 0;
    /// Folders of whose changes the system tells nothing; told when they change.
    virtual void untold(const std::vector<std::filesystem::path>& folders) = 0;
};

/// Brings the index up to date with `indexing.paths` now, whenever something changes below them,
/// and from time to time, until a stop is requested. Paths need not be there: where the index has
/// models of one that is not, as of a disk that is not mounted, they stay (plan_prune).
/// Errors: internal, where folders cannot be watched.
Result<void> keep_indexed(Store& store, const IndexOptions& indexing, const KeepOptions& options,
                          KeepSink& sink, const std::stop_token& stop);

}  // namespace ossuary::index
