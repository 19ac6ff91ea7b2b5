#include "index/grid_numbers.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace ossuary::index {

namespace {

constexpr std::int64_t kMostGridMultiple = std::int64_t{1} << 52;

/// That of the lowest set bit. @pre finite, not 0
int lowest_exponent(double number) {
    int exponent = 0;
    const double mantissa = std::frexp(number, &exponent);
    const auto digits = static_cast<std::uint64_t>(std::abs(std::ldexp(mantissa, 53)));
    return exponent - 53 + std::countr_zero(digits);
}

}  // namespace

std::optional<int> grid_exponent(std::span<const double> numbers) {
    std::optional<int> least;
    double greatest = 0.0;
    for (const double number : numbers) {
        if (!std::isfinite(number) || (number == 0.0 && std::signbit(number))) return {};
        if (number == 0.0) continue;
        least = std::min(least.value_or(kMostGridExponent), lowest_exponent(number));
        greatest = std::max(greatest, std::abs(number));
    }
    if (!least) return 0;
    if (std::ilogb(greatest) - *least >= 52) return {};
    return least;
}

double round_to_grid(double number, int exponent) {
    const double multiple = std::nearbyint(std::ldexp(number, -exponent));
    // Without the sign of a zero.
    return multiple == 0.0 ? 0.0 : std::ldexp(multiple, exponent);
}

std::int64_t grid_multiple(double number, int exponent) {
    const double multiple = std::ldexp(number, -exponent);
    return static_cast<std::int64_t>(
        std::clamp(multiple, -static_cast<double>(kMostGridMultiple), double{kMostGridMultiple}));
}

double grid_number(std::int64_t multiple, int exponent) {
    return std::ldexp(static_cast<double>(multiple), exponent);
}

}  // namespace ossuary::index
