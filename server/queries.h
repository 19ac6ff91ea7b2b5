#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <unordered_map>

#include "engine/core/mutex.h"
#include "index/query_model.h"

namespace ossuary::server {

/// The models that were searched with last, each under a token that only whoever searched with it
/// knows. In memory alone: each goes once nobody has asked for it for a while, or when later ones
/// need its room.
class Queries {
public:
    struct Limits {
        std::size_t bytes = 256 << 20;  ///< of all together (QueryModel::bytes); 0 = keep none
        std::size_t count = 256;
        std::chrono::seconds idle{15 * 60};
    };
    using Clock = std::chrono::steady_clock;

    explicit Queries(Limits limits, std::function<Clock::time_point()> now = Clock::now);

    /// Returns the new token: 32 hexadecimal digits; empty for a model that there is no room for.
    std::string keep(std::shared_ptr<index::QueryModel> model);
    /// Null where it is gone; otherwise its time begins anew.
    std::shared_ptr<index::QueryModel> find(const std::string& token);
    [[nodiscard]] const Limits& limits() const { return limits_; }

private:
    struct Kept {
        std::shared_ptr<index::QueryModel> model;
        std::size_t bytes = 0;
        Clock::time_point used;
    };
    using Map = std::unordered_map<std::string, Kept>;

    void work(const std::stop_token& stop);
    void drop_idle() OSSUARY_REQUIRES(mutex_);
    void drop(Map::iterator kept) OSSUARY_REQUIRES(mutex_);
    void make_room(std::size_t bytes) OSSUARY_REQUIRES(mutex_);

    const Limits limits_;
    const std::function<Clock::time_point()> now_;
    Mutex mutex_;
    Map kept_ OSSUARY_GUARDED_BY(mutex_);
    std::size_t bytes_ OSSUARY_GUARDED_BY(mutex_) = 0;
    std::condition_variable_any wake_;
    std::jthread thread_;  ///< last, so that it ends first
};

}  // namespace ossuary::server
