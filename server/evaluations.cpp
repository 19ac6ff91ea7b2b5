#include "server/evaluations.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "engine/core/stopwatch.h"
#include "server/without_exceptions.h"

namespace ossuary::server {
namespace {

/// Of which state of the collection a key's evaluation is, in the order of time.
template <typename Key>
auto state_of(const Key& key) {
    return std::pair(std::get<std::uint64_t>(key), std::get<index::Revision>(key));
}

}  // namespace

Evaluable evaluable(const index::Snapshot& snapshot) {
    std::map<std::string_view, std::size_t> members;
    snapshot.for_each_block([&](const index::ScanBlock& block, std::size_t) {
        std::vector<std::size_t> counts(block.class_names.size(), 0);
        for (const std::uint32_t number : block.classes) ++counts[number];
        for (std::size_t i = 0; i < counts.size(); ++i) {
            if (!block.class_names[i].empty()) members[block.class_names[i]] += counts[i];
        }
    });
    Evaluable found;
    for (const auto& [name, count] : members) {
        if (count < 2) continue;
        found.models += count;
        ++found.classes;
    }
    return found;
}

Evaluations::Compute evaluate_over(std::filesystem::path index) {
    return [index = std::move(index)](const index::Snapshot& snapshot,
                                      const index::EvaluateOptions& options) {
        auto store = index::Store::open(index, index::Access::kReadWrite);
        const bool writable = store.ok();
        if (!writable) store = index::Store::open(index, index::Access::kReadOnly);
        if (!store) return Result<index::Evaluation>(store.error());
        index::StorePool stores(*store);
        return writable ? index::evaluate_cached(*store, snapshot, stores, options)
                        : index::evaluate(snapshot, stores, options);
    };
}

Evaluations::Evaluations(Compute compute, const Limits& limits, Log& log)
    : compute_(std::move(compute)),
      limits_(limits),
      log_(log),
      thread_([this](std::stop_token stop) { work(std::move(stop)); }) {}

Evaluations::~Evaluations() = default;

std::optional<Evaluations::Shared> Evaluations::peek(const index::Snapshot& snapshot,
                                                     const ranking::RankOptions& options) {
    const Lock lock(mutex_);
    const auto found = results_.find(
        {snapshot.state().replacements, snapshot.revision(), options.ranker, options.rerank});
    if (found == results_.end()) return std::nullopt;
    return found->second;
}

std::size_t Evaluations::sample_of(std::size_t queries) const {
    constexpr std::size_t kLeast = 100;
    if (queries <= limits_.models) return queries;
    return std::min(queries, std::max(kLeast, limits_.models * limits_.models / queries));
}

std::optional<Result<Evaluations::Shared>> Evaluations::get(const Snapshot& snapshot,
                                                            const ranking::RankOptions& options,
                                                            std::stop_token stop) {
    using Answer = Result<Shared>;
    const Evaluable found = evaluable(*snapshot);
    if (found.classes < 2) {
        return Answer(ErrorCode::kEvaluationNotFound,
                      "An evaluation needs two classes with two models each; the collection has " +
                          std::to_string(found.classes) + ".");
    }
    const Key key{snapshot->state().replacements, snapshot->revision(), options.ranker,
                  options.rerank};
    Lock lock(mutex_);
    if (const auto known = results_.find(key); known != results_.end()) {
        return Answer(known->second);
    }
    if (waiting_ >= limits_.waiting) return std::nullopt;
    const std::shared_ptr<Task> task = task_for(key, snapshot, options);
    ++waiting_;
    ++task->waiting;
    changed_.wait(lock, stop, [&] { return task->outcome.has_value(); });
    --waiting_;
    --task->waiting;
    if (task->outcome) return *task->outcome;
    return Answer(ErrorCode::kCancelled, "the evaluation takes longer than the request may");
}

std::shared_ptr<Evaluations::Task> Evaluations::task_for(const Key& key, const Snapshot& snapshot,
                                                         const ranking::RankOptions& options) {
    for (const auto& task : tasks_) {
        if (task->key == key) return task;
    }
    // Those of earlier revisions that nobody waits for any more will not be asked for again.
    if (!tasks_.empty()) {
        const auto superseded = [&](const std::shared_ptr<Task>& task) {
            return task->waiting == 0 && state_of(task->key) < state_of(key);
        };
        tasks_.erase(std::remove_if(std::next(tasks_.begin()), tasks_.end(), superseded),
                     tasks_.end());
    }
    tasks_.push_back(std::make_shared<Task>(Task{key, snapshot, options, 0, std::nullopt}));
    changed_.notify_all();
    return tasks_.back();
}

void Evaluations::work(std::stop_token stop) {
    Lock lock(mutex_);
    while (
        changed_.wait(lock, stop, [this]() OSSUARY_REQUIRES(mutex_) { return !tasks_.empty(); })) {
        if (stop.stop_requested()) return;
        const std::shared_ptr<Task> task = tasks_.front();
        lock.unlock();
        Result<Shared> outcome = without_exceptions([&] { return compute(*task, stop); });
        if (!outcome) {
            log_.error("evaluation: " + std::string(to_string(outcome.error().code)) + ": " +
                       outcome.error().message);
        }
        lock.lock();
        if (outcome) {
            std::erase_if(results_, [&](const auto& entry) {
                return state_of(entry.first) < state_of(task->key);
            });
            results_.insert_or_assign(task->key, *outcome);
        }
        task->outcome = std::move(outcome);
        tasks_.pop_front();
        changed_.notify_all();
    }
}

Result<Evaluations::Shared> Evaluations::compute(const Task& task, std::stop_token stop) {
    const Stopwatch watch;
    index::EvaluateOptions options;
    options.rank = task.options;
    options.rank.stop = std::move(stop);
    const std::size_t queries = evaluable(*task.snapshot).models;
    if (const std::size_t sample = sample_of(queries); sample < queries) options.sample = sample;
    auto evaluation = compute_(*task.snapshot, options);
    if (!evaluation) return evaluation.error();
    log_.info("evaluated " + std::string(to_string(task.options.ranker)) + " over " +
              std::to_string(evaluation->report.models) + " models in " +
              std::to_string(static_cast<long>(watch.elapsed_ms())) + " ms");
    return std::make_shared<const index::Evaluation>(*std::move(evaluation));
}

}  // namespace ossuary::server
