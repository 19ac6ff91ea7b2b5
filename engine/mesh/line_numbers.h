#pragma once

#include <array>
#include <cstddef>

#include "engine/mesh/text_scanner.h"

namespace ossuary::mesh {

/// The numbers on the rest of a line.
struct LineNumbers {
    static constexpr std::size_t kMost = 12;
    std::array<float, kMost> values{};
    std::size_t count = 0;  ///< 0 where one is no number, or there are more than kMost

    /// Three that follow each other.
    [[nodiscard]] std::array<float, 3> three_from(std::size_t first) const {
        return {values[first], values[first + 1], values[first + 2]};
    }
};

/// Reads them and moves to the end of the line, whatever stands there.
inline LineNumbers read_line_numbers(TextScanner& scanner) {
    LineNumbers numbers;
    while (!scanner.at_line_end()) {
        double value = 0.0;
        if (numbers.count == LineNumbers::kMost ||
            scanner.read_double(value) != NumberStatus::kOk) {
            scanner.skip_rest_of_line();
            return {};
        }
        numbers.values[numbers.count++] = static_cast<float>(value);
    }
    return numbers;
}

}  // namespace ossuary::mesh
