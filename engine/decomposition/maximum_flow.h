#pragma once

#include <cstdint>
#include <limits>
#include <stop_token>
#include <utility>
#include <vector>

namespace ossuary::decomposition {

/// Minimum cuts of undirected graphs between a source and a sink, by Dinic's algorithm ("Algorithm
/// for solution of a problem of maximum flow in networks with power estimation", 1970).
class MaximumFlow {
public:
    /// @param max_steps  arcs looked at, after which the search for the cut is given up
    explicit MaximumFlow(std::size_t nodes,
                         std::uint64_t max_steps = std::numeric_limits<std::uint64_t>::max(),
                         std::stop_token stop = {})
        : links_(nodes), steps_left_(max_steps), stop_(std::move(stop)) {}

    /// An edge that lets `capacity` pass in each direction; capacities are integers, so that the
    /// cut does not depend on rounding.
    void add_edge(std::uint32_t a, std::uint32_t b, std::int64_t capacity);

    /// For each node whether it stays on the source's side when the cheapest set of edges that
    /// parts source and sink is cut (of several the one nearest to the source). Empty where it was
    /// given up or a stop was requested.
    std::vector<bool> source_side(std::uint32_t source, std::uint32_t sink);

    [[nodiscard]] std::uint64_t steps_left() const { return steps_left_; }

private:
    struct Arc {
        std::uint32_t to = 0;
        std::uint32_t reverse = 0;  ///< index into the arcs of `to`
        std::int64_t residual = 0;
    };
    /// Counts steps; false when it is time to give up.
    bool spend(std::uint64_t steps);
    bool find_levels(std::uint32_t source, std::uint32_t sink);
    std::int64_t augment(std::uint32_t source, std::uint32_t sink);

    std::vector<std::vector<Arc>> links_;
    std::vector<std::int32_t> level_;
    std::vector<std::size_t> next_arc_;
    std::vector<std::uint32_t> queue_;
    std::uint64_t steps_left_;
    std::stop_token stop_;
};

}  // namespace ossuary::decomposition
