#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "engine/core/mutex.h"

namespace ossuary::server {

/// Which stage each running search is in, under a token that its client has made up, so that only
/// whoever started it can ask. What has ended is not known any more.
class Progress {
public:
    /// A running search; it is known while this lives.
    class Report {
    public:
        Report(Progress& owner, std::string token);
        Report(const Report&) = delete;
        Report& operator=(const Report&) = delete;
        ~Report();
        /// From any thread.
        void stage(std::string_view name);

    private:
        Progress& owner_;
        const std::string token_;  ///< empty: nobody asks, or another search has it
    };

    /// None where no search runs under the token: not yet, or not any more.
    [[nodiscard]] std::optional<std::string> find(const std::string& token) const;

private:
    mutable Mutex mutex_;
    std::unordered_map<std::string, std::string> stages_ OSSUARY_GUARDED_BY(mutex_);
};

/// 32 hexadecimal digits in small letters.
[[nodiscard]] bool is_token(std::string_view text);

}  // namespace ossuary::server
