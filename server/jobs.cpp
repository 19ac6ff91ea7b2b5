#include "server/jobs.h"

#include "index/turn_model.h"

namespace ossuary::server {

std::string_view to_string(JobState state) {
    switch (state) {
        case JobState::kQueued:
            return "queued";
        case JobState::kRunning:
            return "running";
        case JobState::kDone:
            return "done";
        case JobState::kFailed:
            break;
    }
    return "failed";
}

Jobs::Jobs(index::Store store, const Limits& limits, Log& log, Metrics& metrics)
    : store_(std::move(store)),
      limits_(limits),
      log_(log),
      metrics_(metrics),
      thread_([this](std::stop_token stop) { work(stop); }) {}

Jobs::~Jobs() = default;

std::optional<JobId> Jobs::add(index::UploadedModel upload) {
    std::lock_guard lock(mutex_);
    if (waiting_.size() >= limits_.waiting_jobs) return std::nullopt;
    if (!waiting_.empty() && waiting_bytes_ + upload.bytes.size() > limits_.waiting_bytes) {
        return std::nullopt;
    }
    const JobId id = ++last_;
    jobs_[id].id = id;
    waiting_bytes_ += upload.bytes.size();
    waiting_.emplace_back(id, std::move(upload));
    metrics_.jobs(waiting_.size());
    added_.notify_all();
    return id;
}

std::optional<Job> Jobs::find(JobId id) const {
    std::lock_guard lock(mutex_);
    const auto found = jobs_.find(id);
    if (found == jobs_.end()) return std::nullopt;
    return found->second;
}

Result<void> Jobs::remove(index::ModelId id) {
    if (auto removed = store_.remove(id); !removed) return removed;
    return index::update_statistics(store_);
}

Result<index::Orientation> Jobs::turn(index::ModelId id, std::optional<index::Up> up) {
    return index::turn_model(store_, id, up);
}

void Jobs::work(std::stop_token stop) {
    std::unique_lock lock(mutex_);
    while (added_.wait(lock, stop, [this] { return !waiting_.empty(); })) {
        if (stop.stop_requested()) return;
        const auto [id, upload] = std::move(waiting_.front());
        waiting_.pop_front();
        waiting_bytes_ -= upload.bytes.size();
        metrics_.jobs(waiting_.size());
        jobs_[id].state = JobState::kRunning;
        lock.unlock();
        const auto model = index::index_one(store_, upload, stop);
        lock.lock();

        Job& job = jobs_[id];
        job.state = model ? JobState::kDone : JobState::kFailed;
        if (model) {
            job.model = *model;
            log_.info("job " + std::to_string(id) + ": model " + std::to_string(*model));
        } else {
            job.error = model.error();
            log_.warn("job " + std::to_string(id) + ": " +
                      std::string(to_string(model.error().code)) + ": " + model.error().message);
        }
        metrics_.job_done(model.ok());
        while (jobs_.size() > limits_.remembered + limits_.waiting_jobs) {
            jobs_.erase(jobs_.begin());
        }
    }
}

}  // namespace ossuary::server
