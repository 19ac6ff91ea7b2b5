#pragma once

#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ossuary::descriptor {

inline constexpr std::size_t kBodySizeSize = 4;

/// How large a body is in its file: the natural logarithm of its body_scale as a little-endian
/// binary32 number; 0 for none. The only descriptor that scaling changes.
/// @param length  body_scale in the file's unit
[[nodiscard]] inline std::vector<std::uint8_t> body_size(double length) {
    const float logarithm = length > 0.0 ? static_cast<float>(std::log(length)) : 0.0F;
    const auto bits = std::bit_cast<std::uint32_t>(logarithm);
    std::vector<std::uint8_t> bytes;
    for (unsigned shift = 0; shift < 32; shift += 8) {
        bytes.push_back(static_cast<std::uint8_t>((bits >> shift) & 0xFFU));
    }
    return bytes;
}

/// By what factor two bodies differ in size, as a logarithm; 0 for equal ones.
/// @pre kBodySizeSize bytes each
[[nodiscard]] inline double body_size_distance(std::span<const std::uint8_t> a,
                                               std::span<const std::uint8_t> b) {
    assert(a.size() == kBodySizeSize && b.size() == kBodySizeSize);
    const auto number = [](std::span<const std::uint8_t> bytes) {
        std::uint32_t bits = 0;
        for (std::size_t i = 0; i < kBodySizeSize; ++i) {
            bits |= static_cast<std::uint32_t>(bytes[i]) << (8 * i);
        }
        return static_cast<double>(std::bit_cast<float>(bits));
    };
    return std::abs(number(a) - number(b));
}

}  // namespace ossuary::descriptor
