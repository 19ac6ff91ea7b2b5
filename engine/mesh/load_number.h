#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <type_traits>

namespace ossuary::mesh {

/// The number whose bytes begin at `bytes`, which need not be aligned, in the given byte order.
template <typename T>
[[nodiscard]] T load_number(const char* bytes, std::endian order) {
    static_assert(std::is_arithmetic_v<T>);
    std::array<char, sizeof(T)> raw;
    std::memcpy(raw.data(), bytes, sizeof(T));
    if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
    return std::bit_cast<T>(raw);
}

}  // namespace ossuary::mesh
