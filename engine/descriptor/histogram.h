#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ossuary {

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

/// A histogram over two variables with linear sharing between bins.
class JointHistogram {
public:
    JointHistogram(const HistogramAxis& rows, const HistogramAxis& columns)
        : rows_(rows),
          columns_(columns),
          cells_(static_cast<std::size_t>(rows.bins) * static_cast<std::size_t>(columns.bins)) {}

    void add(double row_value, double column_value, double weight) {
        const auto r = rows_.share(row_value);
        const auto c = columns_.share(column_value);
        cell(r.lower, c.lower) += weight * (1.0 - r.upper_share) * (1.0 - c.upper_share);
        cell(r.lower, c.upper) += weight * (1.0 - r.upper_share) * c.upper_share;
        cell(r.upper, c.lower) += weight * r.upper_share * (1.0 - c.upper_share);
        cell(r.upper, c.upper) += weight * r.upper_share * c.upper_share;
    }

    /// Row by row, divided by the sum; all zeros where nothing was added.
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
    double& cell(std::size_t row, std::size_t column) {
        return cells_[row * static_cast<std::size_t>(columns_.bins) + column];
    }

    HistogramAxis rows_;
    HistogramAxis columns_;
    std::vector<double> cells_;
};

}  // namespace ossuary
