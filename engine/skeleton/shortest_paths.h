#pragma once

#include <algorithm>
#include <cstring>
#include <limits>
#include <vector>

#include "engine/skeleton/bucket_queue.h"
#include "engine/skeleton/row_layout.h"

#ifdef __SSE__
#include <xmmintrin.h>
#endif

namespace ossuary {

inline constexpr float kUnreached = std::numeric_limits<float>::infinity();

/// Shortest ways from every voxel (or block) of a set to the nearest of some sources.
class ShortestPaths {
public:
    explicit ShortestPaths(const ThinningGrid& set)
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
    friend ShortestPaths shortest_paths(const ThinningGrid& set, const Links& links,
                                        const SquaredRadius& squared_radius,
                                        const std::vector<VoxelIndex>& sources);

    RowLayout layout_;
    std::vector<float> costs_;         ///< 0 outside the set: nothing is an improvement there
    std::vector<std::uint8_t> steps_;  ///< with kFinal once the cost is
};

namespace detail {

/// Four neighbours along a row, of which the last is one too many.
using RowOfFour [[gnu::vector_size(16)]] = float;

inline unsigned lanes_below(const RowOfFour& a, const RowOfFour& b) {
#ifdef __SSE__
    return static_cast<unsigned>(_mm_movemask_ps(_mm_cmplt_ps(a, b)));
#else
    unsigned lanes = 0;
    for (unsigned i = 0; i < 4; ++i) lanes |= (a[i] < b[i] ? 1u : 0u) << i;
    return lanes;
#endif
}

inline RowOfFour row_of_four(const float* values) {
    RowOfFour row;
    std::memcpy(&row, values, sizeof row);
    return row;
}

inline constexpr std::array<std::array<float, 4>, 9> kRowLengths = [] {
    std::array<std::array<float, 4>, 9> lengths{};
    for (std::size_t bit = 0; bit < 27; ++bit) lengths[bit / 3][bit % 3] = kNeighborLength[bit];
    return lengths;
}();

}  // namespace detail

/// A step costs its length times the mean of 1 / r^2 at its two ends, so that ways keep to the
/// middle of the solid. Neighbours are looked at a row at a time: most are no improvement.
/// @param links           v → its neighbours in the set
/// @param squared_radius  v → r^2 > 0
template <typename Links, typename SquaredRadius>
ShortestPaths shortest_paths(const ThinningGrid& set, const Links& links,
                             const SquaredRadius& squared_radius,
                             const std::vector<VoxelIndex>& sources) {
    ShortestPaths paths(set);
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
    while (!queue.empty()) {
        const VoxelIndex v = queue.pop();
        const std::uint32_t row = layout.row_of(v);
        const std::uint32_t offset = layout.offset_in_row(v, row);
        const std::size_t place = layout.place(offset, row);
        if ((path_steps[place] & ShortestPaths::kFinal) != 0) continue;
        path_steps[place] |= ShortestPaths::kFinal;
        const float here = costs[place];
        const float weight = weights[place];
        std::array<std::size_t, 9> places;  // of the neighbours at dx = 0
        Neighborhood nearer = 0;
        for (std::size_t r = 0; r < 9; ++r) {
            places[r] =
                layout.place(offset, row + static_cast<std::uint32_t>(layout.row_steps()[r]));
            const std::size_t first = places[r] - 1;
            const auto there = here + detail::row_of_four(detail::kRowLengths[r].data()) *
                                          (weight + detail::row_of_four(weights.data() + first));
            nearer |= (detail::lanes_below(there, detail::row_of_four(costs + first)) & 7u)
                      << 3 * r;
        }
        for_each_bit(nearer & links(v), [&](int bit) {
            const auto b = static_cast<std::size_t>(bit);
            const std::size_t n = places[b / 3] + b % 3 - 1;
            if ((path_steps[n] & ShortestPaths::kFinal) != 0) return;
            const float there = here + kNeighborLength[b] * (weight + weights[n]);
            costs[n] = there;
            path_steps[n] = static_cast<std::uint8_t>(opposite_bit(bit));
            queue.push(static_cast<std::uint64_t>(there * levels_per_cost), moved(v, steps[b]));
        });
    }
    return paths;
}

}  // namespace ossuary
