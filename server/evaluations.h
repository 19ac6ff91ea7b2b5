#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <tuple>

#include "engine/core/mutex.h"
#include "engine/core/result.h"
#include "index/evaluation.h"
#include "index/snapshot.h"
#include "server/log.h"

namespace ossuary::server {

/// Whether a collection can be evaluated: two classes or more with two models or more.
struct Evaluable {
    std::size_t models = 0;   ///< of those classes
    std::size_t classes = 0;  ///< with at least two models
};
[[nodiscard]] Evaluable evaluable(const index::Snapshot& snapshot);

/// Evaluates the collection on demand, one evaluation at a time, on a thread of its own, so that a
/// request which does not want to wait leaves nothing half done: the next one finds it finished.
/// Ends within milliseconds when destroyed.
class Evaluations {
public:
    using Snapshot = std::shared_ptr<const index::Snapshot>;
    using Shared = std::shared_ptr<const index::Evaluation>;
    /// Evaluates; must look at `options.rank.stop`.
    using Compute =
        std::function<Result<index::Evaluation>(const index::Snapshot&, index::EvaluateOptions)>;

    struct Limits {
        std::size_t models = 1500;  ///< of larger collections a sample is searched with
        std::size_t waiting = 16;   ///< requests that may wait; they hold a thread each
    };
    Evaluations(Compute compute, const Limits& limits, Log& log);
    ~Evaluations();

    /// Errors: evaluation_not_found, cancelled when `stop` is requested first, those of `compute`.
    /// What failed is not kept: the next call tries again. None when too many wait.
    std::optional<Result<Shared>> get(const Snapshot& snapshot, const ranking::RankOptions& options,
                                      std::stop_token stop);
    /// What `get` has at hand for this revision; none where it would have to compute.
    [[nodiscard]] std::optional<Shared> peek(const index::Snapshot& snapshot,
                                             const ranking::RankOptions& options);
    /// How many of so many queries are searched with: of more than the limit's so many that no more
    /// pairs are compared than at the limit, but a hundred at least.
    [[nodiscard]] std::size_t sample_of(std::size_t queries) const;

private:
    /// The state of the collection's models, see index::CollectionState, and what is evaluated.
    using Key = std::tuple<std::uint64_t, index::Revision, ranking::RankerKind, bool>;
    struct Task {
        Key key;
        Snapshot snapshot;
        ranking::RankOptions options;
        std::size_t waiting = 0;
        std::optional<Result<Shared>> outcome;
    };
    void work(std::stop_token stop);
    Result<Shared> compute(const Task& task, std::stop_token stop);
    std::shared_ptr<Task> task_for(const Key& key, const Snapshot& snapshot,
                                   const ranking::RankOptions& options) OSSUARY_REQUIRES(mutex_);

    const Compute compute_;
    const Limits limits_;
    Log& log_;
    Mutex mutex_;
    std::condition_variable_any changed_;
    /// The first is under way; what they wait for and the outcome are guarded as well.
    std::deque<std::shared_ptr<Task>> tasks_ OSSUARY_GUARDED_BY(mutex_);
    std::map<Key, Shared> results_ OSSUARY_GUARDED_BY(mutex_);  ///< of the latest revision
    std::size_t waiting_ OSSUARY_GUARDED_BY(mutex_) = 0;
    std::jthread thread_;  ///< last, so that it ends first
};

/// Evaluates with the index's own cache, if the file can be written.
[[nodiscard]] Evaluations::Compute evaluate_over(std::filesystem::path index);

}  // namespace ossuary::server
