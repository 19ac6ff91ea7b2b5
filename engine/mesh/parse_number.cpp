#include "engine/mesh/parse_number.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace ossuary::mesh {
namespace {

constexpr std::array kPowersOfTen = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                     1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                     1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

bool is_digit(char c) { return static_cast<unsigned char>(c - '0') < 10; }

/// Whether a decimal number that does not fit a double is too small rather than too large.
bool is_underflow(const char* begin, const char* end) {
    long long magnitude = 0;  // decimal exponent of the first digit that is not zero
    bool seen_point = false;
    bool seen_nonzero = false;
    const char* p = begin;
    for (; p != end && (is_digit(*p) || *p == '.'); ++p) {
        if (*p == '.') {
            seen_point = true;
        } else if (seen_nonzero) {
            if (!seen_point) ++magnitude;
        } else {
            if (seen_point) --magnitude;
            seen_nonzero = *p != '0';
        }
    }
    if (p == end || (*p != 'e' && *p != 'E')) return magnitude < 0;
    ++p;
    const bool negative = p != end && *p == '-';
    if (p != end && (*p == '-' || *p == '+')) ++p;
    long long exponent = 0;
    const auto parsed = std::from_chars(p, end, exponent);
    if (parsed.ec == std::errc::result_out_of_range) return negative;
    return magnitude + (negative ? -exponent : exponent) < 0;
}

/// Every number that the quick path leaves: many digits, large exponents, names of non-numbers.
ParsedNumber<double> parse_double_slowly(const char* begin, const char* end, bool negative) {
    ParsedNumber<double> number;
    // from_chars would take a second sign, which is no number to us.
    if (begin == end || *begin == '-' || *begin == '+') return number;
    double value = 0.0;
    const auto parsed = std::from_chars(begin, end, value);
    if (parsed.ec == std::errc::invalid_argument) return number;
    number.end = parsed.ptr;
    if (parsed.ec == std::errc::result_out_of_range) {
        if (!is_underflow(begin, parsed.ptr)) {
            number.status = NumberStatus::kNonFinite;
            return number;
        }
        value = 0.0;
    }
    number.status = std::isfinite(value) ? NumberStatus::kOk : NumberStatus::kNonFinite;
    number.value = negative ? -value : value;
    return number;
}

}  // namespace

// A 53-bit integer times or divided by a power of ten that a double holds exactly is one correctly
// rounded operation (Clinger, How to Read Floating Point Numbers Accurately, 1990). Model files
// hold little else; std::from_chars alone takes a third longer, strtod six times as long.
ParsedNumber<double> parse_double(const char* begin, const char* end) {
    const char* p = begin;
    const bool negative = p != end && *p == '-';
    if (p != end && (*p == '-' || *p == '+')) ++p;
    const char* const unsigned_begin = p;

    std::uint64_t mantissa = 0;
    for (; p != end && is_digit(*p); ++p) {
        mantissa = mantissa * 10 + static_cast<std::uint64_t>(*p - '0');
    }
    auto digits = p - unsigned_begin;
    int exponent = 0;
    if (p != end && *p == '.') {
        const char* const fraction = ++p;
        for (; p != end && is_digit(*p); ++p) {
            mantissa = mantissa * 10 + static_cast<std::uint64_t>(*p - '0');
        }
        digits += p - fraction;
        exponent = -static_cast<int>(p - fraction);
    }
    const bool has_exponent = p != end && (*p == 'e' || *p == 'E');
    constexpr std::uint64_t kExactIntegers = std::uint64_t{1} << 53;
    if (digits == 0 || digits > 19 || mantissa > kExactIntegers || exponent < -22 || has_exponent) {
        return parse_double_slowly(unsigned_begin, end, negative);
    }
    ParsedNumber<double> number;
    number.end = p;
    number.status = NumberStatus::kOk;
    number.value =
        static_cast<double>(mantissa) / kPowersOfTen[static_cast<std::size_t>(-exponent)];
    if (negative) number.value = -number.value;
    return number;
}

}  // namespace ossuary::mesh
