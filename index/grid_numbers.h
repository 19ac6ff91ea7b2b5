#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ossuary::index {

// Numbers that are multiples of a power of two: they can be written as integers, whose differences
// take few bytes, and give back the same bits.

/// The exponent of the greatest power of two that every number is a multiple of; 0 for zeros alone.
/// None where one is not finite or a negative zero, or where a multiple is beyond 2^52.
[[nodiscard]] std::optional<int> grid_exponent(std::span<const double> numbers);

/// The multiple of 2^exponent that is nearest.
[[nodiscard]] double round_to_grid(double number, int exponent);

/// The multiples. @pre the numbers lie on that grid
[[nodiscard]] std::int64_t grid_multiple(double number, int exponent);

/// The number that a multiple stands for.
[[nodiscard]] double grid_number(std::int64_t multiple, int exponent);

/// The exponents that a number of an index may have.
inline constexpr int kLeastGridExponent = -1074;
inline constexpr int kMostGridExponent = 1023;

}  // namespace ossuary::index
