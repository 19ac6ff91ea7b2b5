#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace ossuary::index {

// The ranges that models are counted and listed in by their numbers, ascending, by the names that
// filters have them by: `5-8` is from 5 up to and with 8, `2` just that, `65-` without an end.

inline constexpr std::array<std::string_view, 8> kBranchRanges = {
    "0", "1-4", "5-8", "9-16", "17-32", "33-64", "65-128", "129-"};
inline constexpr std::array<std::string_view, 7> kLoopRanges = {"0",   "1",    "2",  "3-4",
                                                                "5-8", "9-16", "17-"};

/// The place of the range in kBranchRanges.
[[nodiscard]] std::size_t branch_range(std::uint32_t branches);
/// The place of the range in kLoopRanges.
[[nodiscard]] std::size_t loop_range(std::uint32_t loops);

/// Ranges of longest sides, by tens: `10-100mm` for models whose unit is known, from 10 up to but
/// without 100 mm; then `10-100`, in the files' own numbers, for the others.
[[nodiscard]] std::span<const std::string> extent_ranges();
/// The place of the range in `extent_ranges`.
/// @param metres_per_unit 0 where the unit is not known
[[nodiscard]] std::size_t extent_range(double longest_side, double metres_per_unit);

/// The place of a name among `ranges`; none where it is not one of theirs.
template <typename Ranges>
[[nodiscard]] std::optional<std::size_t> find_range(const Ranges& ranges, std::string_view name) {
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        if (ranges[i] == name) return i;
    }
    return std::nullopt;
}

}  // namespace ossuary::index
