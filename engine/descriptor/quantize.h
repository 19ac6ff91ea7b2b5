#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace ossuary::descriptor {

/// The scale of histograms that sum to one: a quarter of all in one bin fills its byte.
inline constexpr double kHistogramByteScale = 510.0;

/// Square roots in bytes: round(scale * sqrt(value)), at most 255. The root evens out the small and
/// the great values of histograms and spectra; bytes make a descriptor small and its comparison
/// quick, and cost no quality that can be measured.
/// @pre values are not negative
inline void append_root_bytes(std::span<const float> values, double scale,
                              std::vector<std::uint8_t>& bytes) {
    for (const float value : values) {
        const double root = scale * std::sqrt(static_cast<double>(value));
        bytes.push_back(static_cast<std::uint8_t>(std::min(255.0, std::round(root))));
    }
}

}  // namespace ossuary::descriptor
