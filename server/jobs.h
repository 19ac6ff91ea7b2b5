#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>

#include "engine/core/result.h"
#include "index/indexer.h"
#include "index/store.h"
#include "server/log.h"
#include "server/metrics.h"

namespace ossuary::server {

using JobId = std::int64_t;

enum class JobState { kQueued, kRunning, kDone, kFailed };
[[nodiscard]] std::string_view to_string(JobState state);

struct Job {
    JobId id = 0;
    JobState state = JobState::kQueued;
    index::ModelId model = 0;    ///< once done
    std::optional<Error> error;  ///< once failed
};

/// Changes the collection: adds uploaded models one after the other on a thread of its own, and
/// removes models. Has its own, writable store; readers follow by the index's revision.
class Jobs {
public:
    struct Limits {
        std::size_t waiting_jobs = 64;
        std::size_t waiting_bytes = 256 << 20;
        std::size_t remembered = 1000;  ///< finished jobs, the oldest are forgotten first
    };
    Jobs(index::Store store, const Limits& limits, Log& log, Metrics& metrics);
    ~Jobs();

    /// None when too many wait.
    std::optional<JobId> add(index::UploadedModel upload);
    [[nodiscard]] std::optional<Job> find(JobId id) const;
    /// Errors: model_not_found, those of the store.
    Result<void> remove(index::ModelId id);
    /// See index::turn_model.
    Result<index::Orientation> turn(index::ModelId id, std::optional<index::Up> up);

private:
    void work(std::stop_token stop);

    index::Store store_;
    const Limits limits_;
    Log& log_;
    Metrics& metrics_;
    mutable std::mutex mutex_;
    std::condition_variable_any added_;
    std::deque<std::pair<JobId, index::UploadedModel>> waiting_;
    std::size_t waiting_bytes_ = 0;
    std::map<JobId, Job> jobs_;
    JobId last_ = 0;
    std::jthread thread_;  ///< last, so that it ends first
};

}  // namespace ossuary::server
