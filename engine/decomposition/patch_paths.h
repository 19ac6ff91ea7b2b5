#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "engine/decomposition/patches.h"

namespace ossuary::decomposition {

/// A symmetric table with an entry for each two patches.
class PatchTable {
public:
    explicit PatchTable(std::size_t count, float value = 0.0F)
        : count_(count), values_(count * count, value) {}
    [[nodiscard]] float operator()(std::size_t i, std::size_t j) const {
        return values_[i * count_ + j];
    }
    [[nodiscard]] float* row(std::size_t i) { return values_.data() + i * count_; }
    void set(std::size_t i, std::size_t j, float value) {
        values_[i * count_ + j] = values_[j * count_ + i] = value;
    }

private:
    std::size_t count_;
    std::vector<float> values_;
};

/// The cost of stepping over a link of a patch.
using LinkCost = std::function<double(std::size_t from, const PatchGraph::Link& link)>;

/// The least sum of costs between every two patches (Dijkstra's algorithm from each).
PatchTable least_sums(const PatchGraph& graph, const LinkCost& cost);

/// The least largest cost on any way between every two patches, by joining the cheapest links
/// first (Kruskal's algorithm).
PatchTable least_barriers(const PatchGraph& graph, const LinkCost& cost);

/// The electrical resistance between every two patches, each link conducting as much as
/// `conductance` says; and what is left of it when each patch's resistance to all its neighbours
/// at once, which says nothing of what lies between, is taken off (compare von Luxburg, Radl and
/// Hein, "Hitting and commute times in large random neighborhood graphs", 2014).
struct Resistances {
    PatchTable whole;
    PatchTable far;
};
Resistances resistances(const PatchGraph& graph, const LinkCost& conductance);

}  // namespace ossuary::decomposition
