#include "engine/descriptor/thickness.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "engine/descriptor/histogram.h"
#include "engine/descriptor/quantize.h"

namespace ossuary::descriptor {
namespace {

constexpr double kThinnest = 0.02;
constexpr double kThickest = 0.6;
constexpr double kFarthestPair = 3.0;

/// An axis of logarithms of shape diameters over the scale.
HistogramAxis thickness_axis(int bins) { return {std::log(kThinnest), std::log(kThickest), bins}; }

std::vector<double> logarithms(std::span<const float> diameters, double scale) {
    std::vector<double> result;
    result.reserve(diameters.size());
    for (const float diameter : diameters) {
        result.push_back(std::log(static_cast<double>(diameter) / scale));
    }
    return result;
}

}  // namespace

std::vector<std::uint8_t> thickness(const ShellGraph& graph, std::span<const float> diameters,
                                    double scale) {
    assert(diameters.size() == graph.size());
    const std::array<HistogramAxis, 1> axes = {thickness_axis(static_cast<int>(kThicknessSize))};
    SoftHistogram<1> histogram(axes);
    const std::vector<double> thick = logarithms(diameters, scale);
    for (std::size_t i = 0; i < graph.size(); ++i) {
        histogram.add({thick[i]}, static_cast<double>(graph.areas[i]));
    }
    std::vector<std::uint8_t> bytes;
    bytes.reserve(kThicknessSize);
    append_root_bytes(histogram.normalized(), kHistogramByteScale, bytes);
    return bytes;
}

std::vector<std::uint8_t> thickness_pairs(const ShellGraph& graph, const SpreadDistances& spread,
                                          std::span<const float> diameters, double scale) {
    assert(diameters.size() == graph.size());
    SoftHistogram<3> histogram({{{0.0, kFarthestPair, 8}, thickness_axis(8), thickness_axis(8)}});
    const std::vector<double> thick = logarithms(diameters, scale);
    const std::vector<double> shares = spread.shares(graph, spread.sources.size());
    for (std::size_t s = 0; s < spread.sources.size(); ++s) {
        const double here = thick[spread.sources[s]];
        for (std::size_t i = 0; i < graph.size(); ++i) {
            const auto [thin, wide] = std::minmax(here, thick[i]);
            histogram.add({static_cast<double>(spread.from[s][i]) / scale, thin, wide},
                          shares[s] * static_cast<double>(graph.areas[i]));
        }
    }
    std::vector<std::uint8_t> bytes;
    bytes.reserve(kThicknessPairsSize);
    append_root_bytes(histogram.normalized(), kHistogramByteScale, bytes);
    return bytes;
}

}  // namespace ossuary::descriptor
