#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace ossuary {

/// Time since construction or the last `lap`, on the steady clock.
class Stopwatch {
public:
    [[nodiscard]] double elapsed_ms() const {
        return std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
    }
    /// Milliseconds since the last lap; starts the next.
    double lap_ms() {
        const double elapsed = elapsed_ms();
        start_ = Clock::now();
        return elapsed;
    }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
};

/// How long one named stage of the pipeline took.
struct StageTime {
    std::string stage;
    double milliseconds = 0.0;
};

using StageTimes = std::vector<StageTime>;

}  // namespace ossuary
