#pragma once

#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace ossuary::test {

/// A number in [0, 1) with the same bits on every platform, unlike std::uniform_real_distribution.
inline double next_unit(std::mt19937_64& random) {
    return static_cast<double>(random() >> 11) * 0x1p-53;
}

inline std::size_t next_below(std::mt19937_64& random, std::size_t count) {
    return static_cast<std::size_t>(next_unit(random) * static_cast<double>(count));
}

template <typename T>
void shuffle(std::vector<T>& items, std::mt19937_64& random) {
    for (std::size_t i = items.size(); i > 1; --i) {
        std::swap(items[i - 1], items[next_below(random, i)]);
    }
}

}  // namespace ossuary::test
