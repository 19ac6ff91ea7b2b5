#pragma once

#include <cmath>

namespace ossuary::matching {

/// |x - y| / (x + y) in [0, 1]: 0 for two zeros. @pre neither is negative
inline float relative_difference(float x, float y) {
    const float sum = x + y;
    return sum > 0.0F ? std::abs(x - y) / sum : 0.0F;
}

}  // namespace ossuary::matching
