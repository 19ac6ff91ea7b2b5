#include "engine/mesh/text_scanner.h"

#include <algorithm>
#include <array>

namespace ossuary::mesh {

NumberStatus TextScanner::count_failure() const {
    const std::string_view token = peek_token();
    if (token.size() < 2 || token[0] != '-') return NumberStatus::kNotANumber;
    const bool digits_only = token.find_first_not_of("0123456789", 1) == std::string_view::npos;
    return digits_only ? NumberStatus::kNegative : NumberStatus::kNotANumber;
}

bool spells(std::string_view text, std::string_view capitals) {
    return std::equal(text.begin(), text.end(), capitals.begin(), capitals.end(),
                      [](char c, char capital) {
                          return c == capital || (c >= 'a' && c <= 'z' && c - 'a' + 'A' == capital);
                      });
}

std::string quoted_token(std::string_view token) {
    constexpr std::size_t kLongest = 40;
    constexpr std::array kHex = {'0', '1', '2', '3', '4', '5', '6', '7',
                                 '8', '9', 'a', 'b', 'c', 'd', 'e', 'f'};
    std::string quoted = "'";
    for (const char c : token.substr(0, kLongest)) {
        if (c >= ' ' && c <= '~') {
            quoted += c;
        } else {
            const auto byte = static_cast<unsigned char>(c);
            quoted += "\\x";
            quoted += kHex[byte >> 4];
            quoted += kHex[byte & 15];
        }
    }
    if (token.size() > kLongest) quoted += "...";
    return quoted + "'";
}

}  // namespace ossuary::mesh
