#include "server/jobs.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "index/process_mark.h"
#include "index/turn_model.h"
#include "server/without_exceptions.h"

namespace ossuary::server {

namespace {

using namespace std::chrono_literals;

/// Between looks for uploads that another server has accepted, or has left.
constexpr auto kInterval = 1s;
/// Between tries while the index cannot be used, at most.
constexpr auto kLongestInterval = 32s;

std::string label(const index::ClaimedUpload& upload) {
    return "job " + std::to_string(upload.claim.id) + ": ";
}

std::string in_words(const Error& error) {
    return std::string(to_string(error.code)) + ": " + error.message;
}

}  // namespace

std::string_view to_string(index::UploadState state) {
    switch (state) {
        case index::UploadState::kQueued:
            return "queued";
        case index::UploadState::kRunning:
            return "running";
        case index::UploadState::kDone:
            return "done";
        case index::UploadState::kFailed:
            break;
    }
    return "failed";
}

Jobs::Jobs(index::Store store, const Limits& limits, Log& log, Metrics& metrics,
           std::function<void(bool removed)> changed, Describe describe)
    : store_(std::move(store)),
      limits_(limits),
      log_(log),
      metrics_(metrics),
      changed_(std::move(changed)),
      describe_(std::move(describe)),
      mark_(index::process_mark()),
      timer_(limits.model_timeout_seconds) {
    store_.follow_replacements();
    const auto queue = store_.upload_queue();
    if (queue && queue->waiting > 0) {
        log_.info(std::to_string(queue->waiting) + " uploads wait from before");
    }
    thread_ = std::jthread([this](std::stop_token stop) { work(stop); });
}

Jobs::~Jobs() {
    thread_.request_stop();
    thread_.join();
    const auto queue = store_.upload_queue();
    if (!queue) {
        log_.warn("uploads that wait stay in the index; how many cannot be told: " +
                  in_words(queue.error()));
    } else if (queue->waiting > 0) {
        log_.info(std::to_string(queue->waiting) +
                  " uploads stay in the index; the next server adds them");
    }
}

Result<std::optional<index::UploadId>> Jobs::add(const index::UploadedModel& upload) {
    auto added = store_.add_upload(upload, limits_.waiting);
    if (!added || !*added) return added;
    report_queue();
    {
        const Lock lock(mutex_);
        look_ = true;
    }
    added_.notify_all();
    return added;
}

Result<void> Jobs::remove(index::ModelId id) {
    if (auto removed = store_.remove(id); !removed) return removed;
    folded_ = false;
    changed_(true);
    return {};
}

Result<void> Jobs::classify(index::ModelId id, const std::string& class_name) {
    const index::Change change = index::ClassifyModel{id, class_name};
    if (auto done = store_.apply({&change, 1}); !done) return done.error();
    folded_ = false;
    changed_(false);
    return {};
}

Result<index::Orientation> Jobs::turn(index::ModelId id, std::optional<index::Up> up) {
    return index::turn_model(store_, id, up);
}

void Jobs::work(std::stop_token stop) {
    std::chrono::seconds pause = kInterval;
    while (!stop.stop_requested()) {
        // Whatever a model brings about ends with that model, or is tried again; never the thread.
        const auto taken = without_exceptions([&]() -> Result<Turn> { return take_turn(stop); });
        const Turn turn = taken ? *taken : trouble(taken.error());
        if (turn == Turn::kDone) {
            pause = kInterval;
            continue;
        }
        pause = turn == Turn::kNothingWaits
                    ? kInterval
                    : std::min<std::chrono::seconds>(2 * pause, kLongestInterval);
        Lock lock(mutex_);
        added_.wait_for(lock, stop, pause, [&]() OSSUARY_REQUIRES(mutex_) {
            return look_ && turn == Turn::kNothingWaits;
        });
        look_ = false;
    }
}

Jobs::Turn Jobs::take_turn(const std::stop_token& stop) {
    const auto claimed = store_.claim_upload(mark_);
    if (!claimed) return trouble(claimed.error());
    if (!*claimed) {
        last_trouble_.clear();
        // What is done should not hang on a log beside the index.
        if (!folded_.exchange(true)) (void)store_.checkpoint();
        return Turn::kNothingWaits;
    }
    const index::ClaimedUpload& upload = **claimed;
    report_queue();
    if (upload.attempt > limits_.attempts) {
        return fail(upload, {ErrorCode::kUploadAbandoned,
                             "the server ended " + std::to_string(limits_.attempts) +
                                 " times while it worked on this model"});
    }
    auto model = describe(upload, stop);
    if (stop.stop_requested() && (!model || !model->segments)) {
        // Half done by order: the next server begins anew.
        if (const auto released = store_.release_upload(upload.claim); !released) {
            return trouble(released.error());
        }
        return Turn::kDone;
    }
    return finish(upload, std::move(model));
}

Result<index::NewModel> Jobs::describe(const index::ClaimedUpload& upload,
                                       const std::stop_token& stop) {
    const index::ModelTimer::Watch watch(timer_, stop);
    auto model = without_exceptions(
        [&] { return describe_(upload.model, store_.parameters(), watch.token()); });
    if (!model && model.error().code == ErrorCode::kCancelled) {
        return {ErrorCode::kCancelled,
                upload.model.name + ": took longer than " +
                    std::to_string(std::lround(limits_.model_timeout_seconds)) + " s"};
    }
    return model;
}

Jobs::Turn Jobs::finish(const index::ClaimedUpload& upload, Result<index::NewModel> model) {
    if (!model) return fail(upload, model.error());
    const index::Change change = index::PutUpload{upload.claim, *std::move(model)};
    const auto ids = store_.apply({&change, 1});
    if (!ids) {
        // What cannot be stored now may be stored later, except for what never can be.
        return ids.error().code == ErrorCode::kInternal ? fail(upload, ids.error())
                                                        : trouble(ids.error());
    }
    log_.info(label(upload) + "model " + std::to_string(ids->front()));
    metrics_.job_done(true);
    changed_(false);
    report_queue();
    folded_ = false;
    return Turn::kDone;
}

Jobs::Turn Jobs::fail(const index::ClaimedUpload& upload, const Error& error) {
    const index::Change change = index::FailUpload{upload.claim, error};
    if (const auto failed = store_.apply({&change, 1}); !failed) return trouble(failed.error());
    log_.warn(label(upload) + in_words(error));
    metrics_.job_done(false);
    report_queue();
    folded_ = false;
    return Turn::kDone;
}

Jobs::Turn Jobs::trouble(const Error& error) {
    const std::string words = in_words(error);
    if (words != last_trouble_) log_.error("jobs: " + words + "; uploads wait");
    last_trouble_ = words;
    return Turn::kIndexInTrouble;
}

void Jobs::report_queue() {
    const auto queue = store_.upload_queue();
    if (queue) metrics_.jobs(queue->waiting);
}

}  // namespace ossuary::server
