#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ossuary::descriptor {

/// One axis of a histogram: `bins` bins over [low, high]; what lies outside falls into the end
/// bins.
struct HistogramAxis {
    double low = 0.0;
    double high = 1.0;
    int bins = 1;

    /// The two bins nearest to a value and the share of the upper one, so that a value's mass
    /// moves between bins without a jump.
    struct Share {
        std::size_t lower = 0;
        std::size_t upper = 0;
        double upper_share = 0.0;
    };
    [[nodiscard]] Share share(double value) const {
        const double last = bins - 1;
        const double at = (value - low) / (high - low) * bins - 0.5;
        const double position = std::isnan(at) ? 0.0 : std::clamp(at, 0.0, last);
        const auto lower = static_cast<std::size_t>(position);
        const std::size_t upper = std::min(lower + 1, static_cast<std::size_t>(bins - 1));
        return {lower, upper, position - static_cast<double>(lower)};
    }
};

/// A histogram over several variables with linear sharing between bins.
template <std::size_t kDimensions>
class SoftHistogram {
public:
    explicit SoftHistogram(const std::array<HistogramAxis, kDimensions>& axes) : axes_(axes) {
        std::size_t cells = 1;
        for (const HistogramAxis& axis : axes) cells *= static_cast<std::size_t>(axis.bins);
        cells_.assign(cells, 0.0);
    }

    void add(const std::array<double, kDimensions>& values, double weight) {
        std::array<std::size_t, kCorners> cell{};
        std::array<double, kCorners> share{};
        share[0] = weight;
        std::size_t corners = 1;
        for (std::size_t d = 0; d < kDimensions; ++d) {
            const auto [lower, upper, upper_share] = axes_[d].share(values[d]);
            const auto bins = static_cast<std::size_t>(axes_[d].bins);
            for (std::size_t c = 0; c < corners; ++c) {
                cell[corners + c] = cell[c] * bins + upper;
                share[corners + c] = share[c] * upper_share;
                cell[c] = cell[c] * bins + lower;
                share[c] *= 1.0 - upper_share;
            }
            corners *= 2;
        }
        for (std::size_t c = 0; c < kCorners; ++c) cells_[cell[c]] += share[c];
    }

    /// The last variable fastest, divided by the sum; all zeros where nothing was added.
    [[nodiscard]] std::vector<float> normalized() const {
        double total = 0.0;
        for (const double value : cells_) total += value;
        std::vector<float> values;
        values.reserve(cells_.size());
        for (const double value : cells_) {
            values.push_back(total > 0.0 ? static_cast<float>(value / total) : 0.0F);
        }
        return values;
    }

private:
    static constexpr std::size_t kCorners = std::size_t{1} << kDimensions;

    std::array<HistogramAxis, kDimensions> axes_;
    std::vector<double> cells_;
};

}  // namespace ossuary::descriptor
