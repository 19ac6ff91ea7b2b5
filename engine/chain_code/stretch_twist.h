#pragma once

#include <cstddef>
#include <string_view>

namespace ossuary::chain_code {

/// What it takes to turn the shorter of two chain codes into the longer (thesis sec. 3.3.2).
struct StretchTwist {
    std::size_t same = 0;
    std::size_t stretches = 0;  ///< descriptors inserted
    std::size_t twists = 0;     ///< descriptors changed

    /// D(S, P) of eq. 3.6: (twists + stretches) / (same + twists + stretches); 0 for two empty
    /// codes.
    [[nodiscard]] double distance() const;
};

/// The thesis' procedure: descriptor by descriptor; the same → next; else the longer code's
/// descriptor is inserted into the shorter until their lengths agree, and from then on descriptors
/// that differ are twisted. Symmetric in its arguments.
[[nodiscard]] StretchTwist stretch_twist(std::string_view s, std::string_view p);

}  // namespace ossuary::chain_code
