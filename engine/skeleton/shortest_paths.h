#pragma once

#include <algorithm>
#include <limits>
#include <stop_token>
#include <vector>

#include "engine/skeleton/bucket_queue.h"
#include "engine/skeleton/row_layout.h"
#include "engine/skeleton/row_of_four.h"

namespace ossuary::skeleton {

inline constexpr float kUnreached = std::numeric_limits<float>::infinity();

/// Shortest ways from every voxel (or block) of a set to the nearest of some sources.
class VoxelPaths {
public:
    explicit VoxelPaths(const ThinningGrid& set)
        : layout_(set), costs_(layout_.count(), 0.0f), steps_(layout_.count(), kCentreBit) {}

    /// kUnreached where there is no way. @pre `v` is in the set
    [[nodiscard]] float cost(VoxelIndex v) const { return costs_[layout_.place(v)]; }
    /// Bit of the neighbour next on the way; kCentreBit at sources.
    [[nodiscard]] std::uint8_t step(VoxelIndex v) const {
        return steps_[layout_.place(v)] & kStepMask;
    }
    /// The next one on the way. @param steps  of the set's shape
    [[nodiscard]] VoxelIndex next(VoxelIndex v, const std::array<std::int32_t, 27>& steps) const {
        return moved(v, steps[step(v)]);
    }

private:
    static constexpr std::uint8_t kStepMask = 31;
    static constexpr std::uint8_t kFinal = 32;

    template <typename Links, typename SquaredRadius>
    friend VoxelPaths shortest_paths(const ThinningGrid& set, const Links& links,
                                     const SquaredRadius& squared_radius,
                                     const std::vector<VoxelIndex>& sources,
                                     const std::stop_token& stop);

    RowLayout layout_;
    std::vector<float> costs_;         ///< 0 outside the set: nothing is an improvement there
    std::vector<std::uint8_t> steps_;  ///< with kFinal once the cost is
};

/// A step costs its length times the mean of 1 / r^2 at its two ends, so that ways keep to the
/// middle of the solid. Neighbours are looked at a row at a time: most are no improvement.
/// @param links           v → its neighbours in the set
/// @param squared_radius  v → r^2 > 0
/// @param stop  once requested, the ways are not complete and must not be followed
template <typename Links, typename SquaredRadius>
VoxelPaths shortest_paths(const ThinningGrid& set, const Links& links,
                          const SquaredRadius& squared_radius,
                          const std::vector<VoxelIndex>& sources, const std::stop_token& stop) {
    VoxelPaths paths(set);
    const RowLayout& layout = paths.layout_;
    float* const costs = paths.costs_.data();
    std::uint8_t* const path_steps = paths.steps_.data();
    const auto steps = set.shape().neighbor_steps();
    std::vector<float> weights(layout.count(), 0.0f);  // half of 1 / r^2
    std::uint32_t largest = 1;
    set.for_each([&](VoxelIndex v) {
        const std::uint32_t squared = squared_radius(v);
        largest = std::max(largest, squared);
        const std::size_t place = layout.place(v);
        weights[place] = 0.5f / static_cast<float>(squared);
        costs[place] = kUnreached;
    });
    // Levels of the smallest step: whatever is served is final.
    const auto levels_per_cost = static_cast<float>(largest);
    BucketQueue queue(static_cast<std::size_t>(1.7321f * levels_per_cost) + 4);
    queue.restart(0);
    for (const VoxelIndex v : sources) {
        costs[layout.place(v)] = 0.0f;
        queue.push(0, v);
    }
    constexpr unsigned kBetweenLooks = 1 << 14;
    unsigned visits = 0;
    while (!queue.empty()) {
        if (++visits % kBetweenLooks == 0 && stop.stop_requested()) break;
        const VoxelIndex v = queue.pop();
        const NeighborPlaces around(layout, v);
        std::uint8_t& own_step = path_steps[around.centre()];
        if ((own_step & VoxelPaths::kFinal) != 0) continue;
        own_step |= VoxelPaths::kFinal;
        const float here = costs[around.centre()];
        const float weight = weights[around.centre()];
        Neighborhood nearer = 0;
        for (std::size_t r = 0; r < 9; ++r) {
            const std::size_t first = around.row(r);
            const auto there = here + row_of_four(kRowLengths[r].data()) *
                                          (weight + row_of_four(weights.data() + first));
            nearer |= (lanes_below(there, row_of_four(costs + first)) & 7u) << 3 * r;
        }
        for_each_bit(nearer & links(v), [&](int bit) {
            const auto b = static_cast<std::size_t>(bit);
            const std::size_t n = around.of(b);
            if ((path_steps[n] & VoxelPaths::kFinal) != 0) return;
            const float there = here + kNeighborLength[b] * (weight + weights[n]);
            costs[n] = there;
            path_steps[n] = static_cast<std::uint8_t>(opposite_bit(bit));
            queue.push(BucketQueue::level_of(there * levels_per_cost), moved(v, steps[b]));
        });
    }
    return paths;
}

}  // namespace ossuary::skeleton
