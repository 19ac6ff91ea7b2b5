#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace ossuary::descriptor {

/// The sum of absolute differences; whole numbers, so exact and symmetric. Compilers make it one
/// instruction for sixteen bytes.
inline std::uint32_t byte_distance(const std::uint8_t* a, const std::uint8_t* b,
                                   std::size_t count) {
    std::uint32_t sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
        sum += static_cast<std::uint32_t>(std::abs(int{a[i]} - int{b[i]}));
    }
    return sum;
}

}  // namespace ossuary::descriptor
