#include "index/number_ranges.h"

#include <algorithm>
#include <bit>

namespace ossuary::index {

namespace {

/// Where ranges of sides begin, but the first, which begins at 0; the last has no end.
constexpr std::array<double, 10> kSides = {1e-3, 1e-2, 1e-1, 1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6};
constexpr std::size_t kSideRanges = kSides.size() + 1;
constexpr double kMillimetres = 1e3;

std::string side_text(double side) {
    constexpr std::array<std::string_view, 3> kBelowOne = {"0.001", "0.01", "0.1"};
    const auto at =
        static_cast<std::size_t>(std::find(kSides.begin(), kSides.end(), side) - kSides.begin());
    return at < kBelowOne.size() ? std::string(kBelowOne[at])
                                 : "1" + std::string(at - kBelowOne.size(), '0');
}

std::array<std::string, 2 * kSideRanges> name_extents() {
    std::array<std::string, 2 * kSideRanges> names;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::size_t range = i % kSideRanges;
        names[i] = (range == 0 ? "0" : side_text(kSides[range - 1])) + "-" +
                   (range == kSides.size() ? "" : side_text(kSides[range])) +
                   (i < kSideRanges ? "mm" : "");
    }
    return names;
}

/// How often a number above 0 can be halved, rounded up.
std::size_t halvings(std::uint32_t number) {
    return static_cast<std::size_t>(std::bit_width(number - 1));
}

}  // namespace

std::size_t branch_range(std::uint32_t branches) {
    if (branches == 0) return 0;
    // Up to 4 one range, then one for each doubling.
    constexpr std::size_t kFirst = 2;
    const std::size_t doublings = std::max(halvings(branches), kFirst) - kFirst;
    return std::min(1 + doublings, kBranchRanges.size() - 1);
}

std::size_t loop_range(std::uint32_t loops) {
    if (loops == 0) return 0;
    return std::min(1 + halvings(loops), kLoopRanges.size() - 1);
}

std::span<const std::string> extent_ranges() {
    static const auto kNames = name_extents();
    return kNames;
}

std::size_t extent_range(double longest_side, double metres_per_unit) {
    const bool known = metres_per_unit > 0.0;
    // By what is read off a ruler: 0.1 m are 100 mm, whatever their products are.
    constexpr double kRounding = 1.0 + 1e-9;
    const double side =
        (known ? longest_side * metres_per_unit * kMillimetres : longest_side) * kRounding;
    const auto above = std::upper_bound(kSides.begin(), kSides.end(), side);
    return static_cast<std::size_t>(above - kSides.begin()) + (known ? 0 : kSideRanges);
}

}  // namespace ossuary::index
