#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "engine/skeleton/bucket_queue.h"
#include "engine/skeleton/voxel_map.h"

namespace ossuary {

inline constexpr float kUnreached = std::numeric_limits<float>::infinity();

/// Shortest ways from every voxel (or block) of a set to the nearest of some sources.
struct ShortestPaths {
    VoxelMap<float> cost;
    VoxelMap<std::uint8_t> step;  ///< bit of the neighbour next on the way; kCentreBit at sources

    /// The next one on the way. @param steps  of the set's shape
    [[nodiscard]] VoxelIndex next(VoxelIndex v, const std::array<std::int32_t, 27>& steps) const {
        return moved(v, steps[step[v]]);
    }
};

/// A step costs its length times the mean of 1 / r^2 at its two ends, so that ways keep to the
/// middle of the solid.
/// @param links           v → its neighbours in the set
/// @param squared_radius  v → r^2 > 0
template <typename Links, typename SquaredRadius>
ShortestPaths shortest_paths(const ThinningGrid& set, const Links& links,
                             const SquaredRadius& squared_radius,
                             const std::vector<VoxelIndex>& sources) {
    ShortestPaths paths{VoxelMap<float>(set, kUnreached),
                        VoxelMap<std::uint8_t>(set, std::uint8_t{kCentreBit})};
    const auto steps = set.shape().neighbor_steps();
    VoxelMap<float> weights(set, 0.0f);  // half of 1 / r^2
    std::uint32_t largest = 1;
    set.for_each([&](VoxelIndex v) {
        const std::uint32_t squared = squared_radius(v);
        largest = std::max(largest, squared);
        weights[v] = 0.5f / static_cast<float>(squared);
    });
    // Levels of the smallest step: whatever is served is final.
    const auto levels_per_cost = static_cast<float>(largest);
    BucketQueue queue(static_cast<std::size_t>(1.7321f * levels_per_cost) + 4);
    queue.restart(0);
    for (const VoxelIndex v : sources) {
        paths.cost[v] = 0.0f;
        queue.push(0, v);
    }
    ThinningGrid open = set;
    while (!queue.empty()) {
        const VoxelIndex v = queue.pop();
        if (!open.test(v)) continue;
        open.reset(v);
        const float here = paths.cost[v];
        const float weight = weights[v];
        for_each_bit(links(v) & open.neighborhood(v), [&](int bit) {
            const auto b = static_cast<std::size_t>(bit);
            const VoxelIndex n = moved(v, steps[b]);
            const float there = here + kNeighborLength[b] * (weight + weights[n]);
            if (there < paths.cost[n]) {
                paths.cost[n] = there;
                paths.step[n] = static_cast<std::uint8_t>(opposite_bit(bit));
                queue.push(static_cast<std::uint64_t>(there * levels_per_cost), n);
            }
        });
    }
    return paths;
}

}  // namespace ossuary
