#include "engine/decomposition/refine_borders.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "engine/decomposition/maximum_flow.h"
#include "engine/mesh/edge_table.h"

namespace ossuary::decomposition {
namespace {

constexpr std::uint32_t kOutside = 0xFFFFFFFFU;
constexpr std::int64_t kUncuttable = std::int64_t{1} << 40;
constexpr double kCapacityUnits = 1e6;  // for a side as long as the square root of the area

/// The parts of two numbers each that share a border, ascending.
std::vector<std::pair<std::uint32_t, std::uint32_t>> touching_parts(
    const SurfaceGraph& surface, const std::vector<std::uint32_t>& labels) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> touching;
    for (std::size_t t = 0; t < surface.size(); ++t) {
        for (const std::uint32_t other : surface.across[t]) {
            if (other == mesh::kNoTriangle || labels[t] >= labels[other]) continue;
            touching.emplace_back(labels[t], labels[other]);
        }
    }
    std::sort(touching.begin(), touching.end());
    touching.erase(std::unique(touching.begin(), touching.end()), touching.end());
    return touching;
}

/// Arcs that all cuts of a surface may look at, some seconds' worth; borders that come after stay
/// where they are.
constexpr std::uint64_t kMostSteps = 100'000'000;

class BorderRefinement {
public:
    BorderRefinement(const SurfaceGraph& surface, std::vector<std::uint32_t>& labels,
                     const RefineBordersOptions& options, const std::stop_token& stop)
        : surface_(surface),
          labels_(labels),
          options_(options),
          stop_(stop),
          scale_(std::sqrt(surface.total_area)),
          node_(surface.size(), kOutside) {}

    void between(std::uint32_t a, std::uint32_t b) {
        find_band(a, b);
        if (band_.empty()) return;
        // Node 0 is the rest of part a, node 1 that of part b.
        MaximumFlow flow(band_.size() + 2, steps_left_, stop_);
        bool has_a = false, has_b = false;
        for (const std::uint32_t t : band_) {
            for (std::size_t side = 0; side < 3; ++side) {
                const std::uint32_t other = surface_.across[t][side];
                if (other == mesh::kNoTriangle) continue;
                if (node_[other] != kOutside) {
                    if (t < other) flow.add_edge(node_[t], node_[other], capacity(t, side));
                } else if (labels_[other] == a || labels_[other] == b) {
                    const bool is_a = labels_[other] == a;
                    (is_a ? has_a : has_b) = true;
                    flow.add_edge(is_a ? 0 : 1, node_[t], kUncuttable);
                }
            }
        }
        // A part that lies in the band with all it has would be swallowed.
        if (has_a && has_b) {
            const std::vector<bool> on_side_a = flow.source_side(0, 1);
            steps_left_ = flow.steps_left();
            for (const std::uint32_t t : band_) {
                if (!on_side_a.empty()) labels_[t] = on_side_a[node_[t]] ? a : b;
            }
        }
        for (const std::uint32_t t : band_) node_[t] = kOutside;
    }

private:
    /// The triangles of the two parts within reach of their common border, numbered from 2.
    void find_band(std::uint32_t a, std::uint32_t b) {
        band_.clear();
        std::vector<std::pair<double, std::uint32_t>> open;
        const auto push = [&](double distance, std::uint32_t t) {
            open.emplace_back(-distance, t);
            std::push_heap(open.begin(), open.end());
        };
        for (std::uint32_t t = 0; t < surface_.size(); ++t) {
            if (labels_[t] != a && labels_[t] != b) continue;
            for (const std::uint32_t other : surface_.across[t]) {
                if (other == mesh::kNoTriangle || labels_[other] == labels_[t]) continue;
                if (labels_[other] == a || labels_[other] == b) {
                    push(0.0, t);
                    break;
                }
            }
        }
        while (!open.empty()) {
            std::pop_heap(open.begin(), open.end());
            const auto [negative, t] = open.back();
            open.pop_back();
            if (node_[t] != kOutside) continue;
            node_[t] = static_cast<std::uint32_t>(band_.size()) + 2;
            band_.push_back(t);
            for (const std::uint32_t other : surface_.across[t]) {
                if (other == mesh::kNoTriangle || node_[other] != kOutside) continue;
                if (labels_[other] != labels_[t]) continue;
                const double step = (surface_.centers[other] - surface_.centers[t]).norm();
                if (step - negative <= options_.reach * scale_) push(step - negative, other);
            }
        }
    }

    [[nodiscard]] std::int64_t capacity(std::uint32_t t, std::size_t side) const {
        const std::uint32_t other = surface_.across[t][side];
        if (surface_.first_of_face[t] == surface_.first_of_face[other]) return kUncuttable;
        const double length = static_cast<double>(surface_.side_lengths[t][side]) / scale_;
        const double turn = std::max(0.0, static_cast<double>(surface_.turns[t][side]));
        const double cost = length * std::exp(-options_.crease_weight * turn);
        return 1 + static_cast<std::int64_t>(kCapacityUnits * cost);
    }

    const SurfaceGraph& surface_;
    std::vector<std::uint32_t>& labels_;
    const RefineBordersOptions& options_;
    const std::stop_token& stop_;
    std::uint64_t steps_left_ = kMostSteps;
    double scale_;
    std::vector<std::uint32_t> band_;
    std::vector<std::uint32_t> node_;  ///< of each triangle of the band
};

}  // namespace

void refine_borders(const SurfaceGraph& surface, std::vector<std::uint32_t>& labels,
                    const RefineBordersOptions& options, const std::stop_token& stop) {
    BorderRefinement refinement(surface, labels, options, stop);
    for (const auto& [a, b] : touching_parts(surface, labels)) {
        if (stop.stop_requested()) return;
        refinement.between(a, b);
    }
}

}  // namespace ossuary::decomposition
