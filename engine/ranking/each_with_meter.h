#pragma once

#include <algorithm>
#include <cstddef>

#include "engine/core/parallel.h"
#include "engine/ranking/pair_distances.h"

namespace ossuary::ranking {

/// Calls body(meter, i) once for each i below `count` on `options.jobs` threads, in blocks that
/// share a meter; `body` must write only what belongs to i. No more calls once asked to stop.
template <typename Body>
void for_each_with_meter(std::size_t count, const RankOptions& options, const Body& body) {
    constexpr std::size_t kModelsPerMeter = 32;
    parallel_for((count + kModelsPerMeter - 1) / kModelsPerMeter, options.jobs,
                 [&](std::size_t block) {
                     PairMeter meter(options);
                     const std::size_t end = std::min(count, (block + 1) * kModelsPerMeter);
                     for (std::size_t i = block * kModelsPerMeter;
                          i < end && !options.stop.stop_requested(); ++i) {
                         body(meter, i);
                     }
                 });
}

}  // namespace ossuary::ranking
