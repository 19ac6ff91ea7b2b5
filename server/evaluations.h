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
#include <thread>
#include <tuple>
#include <vector>

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
class Evaluations {
public:
    /// @param max_models  larger collections are not evaluated
    Evaluations(std::filesystem::path index, std::size_t max_models, Log& log);
    ~Evaluations();

    using Shared = std::shared_ptr<const index::Evaluation>;
    using Snapshot = std::shared_ptr<const index::Snapshot>;

    /// Errors: evaluation_not_found, cancelled when `stop` is requested first, those of `evaluate`.
    Result<Shared> get(const Snapshot& snapshot, const ranking::RankOptions& options,
                       std::stop_token stop);
    /// What `get` has at hand for this revision; none where it would have to compute.
    [[nodiscard]] std::optional<Shared> peek(const index::Snapshot& snapshot,
                                             const ranking::RankOptions& options);
    [[nodiscard]] std::size_t max_models() const { return max_models_; }

private:
    /// The state of the collection's models, see index::CollectionState, and what is evaluated.
    using Key = std::tuple<std::uint64_t, index::Revision, ranking::RankerKind, bool>;
    struct Task {
        Key key;
        Snapshot snapshot;
        ranking::RankOptions options;
    };
    void work(std::stop_token stop);
    Result<Shared> compute(const Task& task);

    const std::filesystem::path index_;
    const std::size_t max_models_;
    Log& log_;
    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::deque<Task> tasks_;  ///< the first is under way
    std::map<Key, Result<Shared>> results_;
    std::jthread thread_;  ///< last, so that it ends first
};

}  // namespace ossuary::server
