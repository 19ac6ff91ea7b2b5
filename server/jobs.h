#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>

#include "engine/core/mutex.h"
#include "engine/core/result.h"
#include "index/indexer.h"
#include "index/model_timer.h"
#include "index/store.h"
#include "index/upload.h"
#include "server/log.h"
#include "server/metrics.h"

namespace ossuary::server {

[[nodiscard]] std::string_view to_string(index::UploadState state);

/// Changes the collection: adds uploaded models one after the other on a thread of its own, and
/// removes models. Has its own, writable store; readers follow by the index's revision. What has
/// been accepted waits in the index, so that it is done by the next server should this one end.
class Jobs {
public:
    struct Limits {
        index::UploadLimits waiting;
        double model_timeout_seconds = 600.0;  ///< for one model; 0 = for ever
        int attempts = 3;  ///< an upload in whose middle so many servers ended is given up
    };
    /// How a model is described; another in tests.
    using Describe = std::function<Result<index::NewModel>(
        const index::UploadedModel&, const index::IndexParameters&, std::stop_token)>;

    /// @param changed  called after each change, with true where a model was removed
    Jobs(index::Store store, const Limits& limits, Log& log, Metrics& metrics,
         std::function<void(bool removed)> changed, Describe describe);
    /// Leaves what waits, and what is under way, to the next server.
    ~Jobs();

    /// The upload's number once it is safe in the index; none when too many wait.
    Result<std::optional<index::UploadId>> add(const index::UploadedModel& upload);
    /// Errors: model_not_found, those of the store.
    Result<void> remove(index::ModelId id);
    /// Empty: no class. Errors: model_not_found, those of the store.
    Result<void> classify(index::ModelId id, const std::string& class_name);
    /// See index::turn_model.
    Result<index::Orientation> turn(index::ModelId id, std::optional<index::Up> up);

private:
    /// What became of a look at the queue.
    enum class Turn { kDone, kNothingWaits, kIndexInTrouble };

    void work(std::stop_token stop);
    Turn take_turn(const std::stop_token& stop);
    Result<index::NewModel> describe(const index::ClaimedUpload& upload,
                                     const std::stop_token& stop);
    Turn finish(const index::ClaimedUpload& upload, Result<index::NewModel> model);
    Turn fail(const index::ClaimedUpload& upload, const Error& error);
    Turn trouble(const Error& error);
    void report_queue();

    index::Store store_;
    const Limits limits_;
    Log& log_;
    Metrics& metrics_;
    const std::function<void(bool removed)> changed_;
    const Describe describe_;
    const std::string mark_;
    index::ModelTimer timer_;
    std::string last_trouble_;          ///< of the thread
    std::atomic<bool> folded_ = false;  ///< whether the log was folded in since the last change
    Mutex mutex_;
    std::condition_variable_any added_;
    bool look_ OSSUARY_GUARDED_BY(mutex_) = false;  ///< something was added
    std::jthread thread_;                           ///< last, so that it ends first
};

}  // namespace ossuary::server
