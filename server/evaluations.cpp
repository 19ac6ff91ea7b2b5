#include "server/evaluations.h"

#include <algorithm>

#include "engine/core/stopwatch.h"

namespace ossuary::server {

Evaluable evaluable(const index::Snapshot& snapshot) {
    std::map<std::string_view, std::size_t> members;
    for (const index::ModelSummary& model : snapshot.models()) {
        if (!model.class_name.empty()) ++members[model.class_name];
    }
    Evaluable found;
    for (const auto& [name, count] : members) {
        if (count < 2) continue;
        found.models += count;
        ++found.classes;
    }
    return found;
}

Evaluations::Evaluations(std::filesystem::path index, std::size_t max_models, Log& log)
    : index_(std::move(index)),
      max_models_(max_models),
      log_(log),
      thread_([this](std::stop_token stop) { work(stop); }) {}

Evaluations::~Evaluations() = default;

std::optional<Evaluations::Shared> Evaluations::peek(const index::Snapshot& snapshot,
                                                     const ranking::RankOptions& options) {
    std::lock_guard lock(mutex_);
    const auto found = results_.find(
        {snapshot.state().replacements, snapshot.revision(), options.ranker, options.rerank});
    if (found == results_.end() || !found->second) return std::nullopt;
    return *found->second;
}

Result<Evaluations::Shared> Evaluations::get(const Snapshot& snapshot,
                                             const ranking::RankOptions& options,
                                             std::stop_token stop) {
    const Evaluable found = evaluable(*snapshot);
    if (found.classes < 2) {
        return {ErrorCode::kEvaluationNotFound,
                "An evaluation needs two classes with two models each; the collection has " +
                    std::to_string(found.classes) + "."};
    }
    if (found.models > max_models_) {
        return {ErrorCode::kEvaluationNotFound,
                "The collection has " + std::to_string(found.models) +
                    " models with a class; this server evaluates at most " +
                    std::to_string(max_models_) + ". `ossuary evaluate` has no limit."};
    }
    const Key key{snapshot->state().replacements, snapshot->revision(), options.ranker,
                  options.rerank};
    std::unique_lock lock(mutex_);
    const auto is_this = [&](const Task& task) { return task.key == key; };
    if (!results_.contains(key) && std::none_of(tasks_.begin(), tasks_.end(), is_this)) {
        tasks_.push_back({key, snapshot, options});
        changed_.notify_all();
    }
    if (!changed_.wait(lock, stop, [&] { return results_.contains(key); })) {
        return {ErrorCode::kCancelled, "the evaluation takes longer than the request may"};
    }
    return results_.at(key);
}

void Evaluations::work(std::stop_token stop) {
    std::unique_lock lock(mutex_);
    while (changed_.wait(lock, stop, [this] { return !tasks_.empty(); })) {
        const Task task = tasks_.front();
        lock.unlock();
        Result<Shared> result = compute(task);
        lock.lock();
        // Those of earlier revisions will not be asked for again.
        const auto state_of = [](const Key& key) {
            return std::pair(std::get<std::uint64_t>(key), std::get<index::Revision>(key));
        };
        std::erase_if(results_, [&](const auto& entry) {
            return state_of(entry.first) < state_of(task.key);
        });
        results_.insert_or_assign(task.key, std::move(result));
        tasks_.pop_front();
        changed_.notify_all();
    }
}

Result<Evaluations::Shared> Evaluations::compute(const Task& task) {
    const Stopwatch watch;
    index::EvaluateOptions options;
    options.rank = task.options;
    auto store = index::Store::open(index_, index::Access::kReadWrite);
    auto evaluation = store ? index::evaluate_cached(*store, *task.snapshot, options)
                            : index::evaluate(*task.snapshot, options);
    if (!evaluation) {
        log_.error("evaluation: " + std::string(to_string(evaluation.error().code)) + ": " +
                   evaluation.error().message);
        return evaluation.error();
    }
    log_.info("evaluated " + std::string(to_string(task.options.ranker)) + " over " +
              std::to_string(evaluation->report.models) + " models in " +
              std::to_string(static_cast<long>(watch.elapsed_ms())) + " ms");
    return std::make_shared<const index::Evaluation>(*std::move(evaluation));
}

}  // namespace ossuary::server
