#pragma once

#include <cstddef>
#include <functional>

namespace ossuary {

/// The number of workers that `jobs` stands for: itself, or the machine's hardware threads for 0.
[[nodiscard]] int resolve_jobs(int jobs);

/// Calls `body(i)` once for each i in [0, count) on at most `jobs` threads (0 = all hardware
/// threads), in no particular order; returns when all are done. `body` must not throw and must
/// write only what belongs to i, so that the outcome does not depend on `jobs`.
void parallel_for(std::size_t count, int jobs, const std::function<void(std::size_t)>& body);

}  // namespace ossuary
