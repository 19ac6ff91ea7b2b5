#pragma once

#include <array>
#include <cstring>

#include "engine/skeleton/neighborhood.h"

#ifdef __SSE__
#include <xmmintrin.h>
#endif

namespace ossuary::skeleton {

/// Four neighbours along a row, of which the last is one too many.
using RowOfFour [[gnu::vector_size(16)]] = float;

inline unsigned lanes_below(const RowOfFour& a, const RowOfFour& b) {
#ifdef __SSE__
    return static_cast<unsigned>(_mm_movemask_ps(_mm_cmplt_ps(a, b)));
#else
    unsigned lanes = 0;
    for (unsigned i = 0; i < 4; ++i) lanes |= (a[i] < b[i] ? 1u : 0u) << i;
    return lanes;
#endif
}

inline RowOfFour row_of_four(const float* values) {
    RowOfFour row;
    std::memcpy(&row, values, sizeof row);
    return row;
}

inline constexpr std::array<std::array<float, 4>, 9> kRowLengths = [] {
    std::array<std::array<float, 4>, 9> lengths{};
    for (std::size_t bit = 0; bit < 27; ++bit) lengths[bit / 3][bit % 3] = kNeighborLength[bit];
    return lengths;
}();

}  // namespace ossuary::skeleton
