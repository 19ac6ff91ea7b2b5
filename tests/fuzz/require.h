#pragma once

#include <cstdlib>

namespace ossuary::fuzz {

/// Aborts where a property does not hold, which libFuzzer reports with the input.
inline void require(bool condition) {
    if (!condition) std::abort();
}

}  // namespace ossuary::fuzz
