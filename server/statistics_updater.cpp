#include "server/statistics_updater.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

#include "engine/core/stopwatch.h"
#include "index/indexer.h"
#include "server/without_exceptions.h"

namespace ossuary::server {
namespace {

/// Of the calling thread alone, as Linux has it.
void step_behind() {
    constexpr int kNice = 10;
    setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNice);
}

/// Before what failed for a reason that may pass is tried again.
constexpr std::chrono::seconds kRetry(5);

/// Of another program that writes for long, or a full disk.
bool is_passing(ErrorCode code) {
    return code == ErrorCode::kIndexBusy || code == ErrorCode::kIndexIo;
}

}  // namespace

StatisticsUpdater::StatisticsUpdater(index::Store store, index::Searcher& searcher, Log& log)
    : store_(std::move(store)), searcher_(searcher), log_(log) {
    store_.follow_replacements();
    thread_ = std::jthread([this](const std::stop_token& stop) { work(stop); });
}

StatisticsUpdater::~StatisticsUpdater() = default;

void StatisticsUpdater::request(When when) {
    {
        const Lock lock(mutex_);
        if (wanted_ != When::kOutdated) wanted_ = when;
    }
    requested_.notify_all();
}

void StatisticsUpdater::work(const std::stop_token& stop) {
    step_behind();
    Lock lock(mutex_);
    const auto wanted = [this]() OSSUARY_REQUIRES(mutex_) { return wanted_.has_value(); };
    while (requested_.wait(lock, stop, wanted)) {
        const When when = *std::exchange(wanted_, std::nullopt);
        lock.unlock();
        const Stopwatch watch;
        const auto updated = without_exceptions([&] { return update(when, stop); });
        auto rest = std::chrono::duration<double, std::milli>(watch.elapsed_ms());
        if (!updated && !stop.stop_requested()) report(updated.error());
        lock.lock();
        if (!updated && is_passing(updated.error().code)) {
            if (wanted_ != When::kOutdated) wanted_ = when;
            rest = std::max<decltype(rest)>(rest, kRetry);
        }
        requested_.wait_for(lock, stop, rest, [] { return false; });
    }
}

void StatisticsUpdater::report(const Error& error) {
    log_.error("statistics: " + std::string(to_string(error.code)) + ": " + error.message);
}

Result<void> StatisticsUpdater::update(When when, const std::stop_token& stop) {
    const Stopwatch watch;
    const auto snapshot = searcher_.snapshot();
    if (!snapshot) return snapshot.error();
    const index::CollectionState& state = (*snapshot)->state();
    if (state.statistics == state.models) return {};
    if (when == When::kMissing && state.statistics >= 0) return {};
    auto updated = index::update_statistics(store_, **snapshot, 1, stop);
    if (!updated) return updated;
    log_.info("statistics of " + std::to_string((*snapshot)->size()) + " models in " +
              std::to_string(static_cast<long>(watch.elapsed_ms())) + " ms");
    return {};
}

}  // namespace ossuary::server
