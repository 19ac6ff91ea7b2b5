#pragma once

namespace ossuary::mesh {

enum class NumberStatus {
    kOk,
    kNotANumber,  ///< not a decimal number, or glued to something that is not part of one
    kNonFinite,   ///< nan, inf or beyond the range of double
    kNegative,    ///< a negative number where only non-negative ones make sense
    kTooLarge,    ///< an integer beyond 64 bits
};

/// The number that was read and where it ends; `end` is meaningful for kOk only.
template <typename T>
struct ParsedNumber {
    T value{};
    const char* end = nullptr;
    NumberStatus status = NumberStatus::kNotANumber;
};

/// Reads a decimal floating-point number from [begin, end): correctly rounded, independent of the
/// locale, with an optional sign, and with exponents marked by e or E. Underflow gives zero.
ParsedNumber<double> parse_double(const char* begin, const char* end);

}  // namespace ossuary::mesh
