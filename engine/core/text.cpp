#include "engine/core/text.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <optional>

namespace ossuary {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

/// What stands at the beginning of some bytes: a character, or so many that belong to none.
struct Decoded {
    std::size_t length = 1;
    std::optional<std::uint32_t> character;
};

struct Lead {
    unsigned char first, last;      // leading bytes
    unsigned char lowest, highest;  // that the second byte may be
    std::size_t length;
};
/// The Unicode Standard, table 3-7: no overlong forms, no surrogates, nothing above U+10FFFF.
constexpr std::array kLeads = {
    Lead{0xC2, 0xDF, 0x80, 0xBF, 2}, Lead{0xE0, 0xE0, 0xA0, 0xBF, 3},
    Lead{0xE1, 0xEC, 0x80, 0xBF, 3}, Lead{0xED, 0xED, 0x80, 0x9F, 3},
    Lead{0xEE, 0xEF, 0x80, 0xBF, 3}, Lead{0xF0, 0xF0, 0x90, 0xBF, 4},
    Lead{0xF1, 0xF3, 0x80, 0xBF, 4}, Lead{0xF4, 0xF4, 0x80, 0x8F, 4},
};

Decoded decode(std::string_view bytes) {
    const auto at = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
    const unsigned char lead = at(0);
    if (lead < 0x80) return {1, lead};
    const auto row = std::find_if(kLeads.begin(), kLeads.end(), [&](const Lead& each) {
        return each.first <= lead && lead <= each.last;
    });
    if (row == kLeads.end()) return {};
    std::uint32_t character = lead & (0xFFu >> (row->length + 1));
    for (std::size_t i = 1; i < row->length; ++i) {
        const unsigned char lowest = i == 1 ? row->lowest : 0x80;
        const unsigned char highest = i == 1 ? row->highest : 0xBF;
        if (i == bytes.size() || at(i) < lowest || at(i) > highest) return {i, {}};
        character = character << 6 | (at(i) & 0x3Fu);
    }
    return {row->length, character};
}

/// Calls body(bytes, character or none) for what `text` consists of.
template <typename Body>
void for_each_character(std::string_view text, const Body& body) {
    while (!text.empty()) {
        const Decoded decoded = decode(text);
        body(text.substr(0, decoded.length), decoded.character);
        text.remove_prefix(decoded.length);
    }
}

/// Control characters, and format characters that show text in another order than it has (Unicode
/// Technical Report 36, sec. 3.2), separate lines, or annotate invisibly.
bool is_control(std::uint32_t c) {
    return c < 0x20 || (c >= 0x7F && c <= 0x9F) || c == 0x061C || c == 0x200E || c == 0x200F ||
           (c >= 0x2028 && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069) || c == 0xFEFF ||
           (c >= 0xFFF9 && c <= 0xFFFB) || (c >= 0xE0000 && c <= 0xE007F);
}

std::string hexadecimal(const char* format, std::uint32_t value) {
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), format, value);
    return text.data();
}

std::string terminal_escape(std::uint32_t c) {
    switch (c) {
        case '\n':
            return "\\n";
        case '\r':
            return "\\r";
        case '\t':
            return "\\t";
        default:
            break;
    }
    if (c < 0x80) return hexadecimal("\\x%02x", c);
    return hexadecimal(c > 0xFFFF ? "\\U%08x" : "\\u%04x", c);
}

std::string json_escape(std::uint32_t c) {
    if (c <= 0xFFFF) return hexadecimal("\\u%04x", c);
    const std::uint32_t above = c - 0x10000;
    return hexadecimal("\\u%04x", 0xD800 + (above >> 10)) +
           hexadecimal("\\u%04x", 0xDC00 + (above & 0x3FF));
}

}  // namespace

std::string valid_utf8(std::string_view text) {
    std::string valid;
    valid.reserve(text.size());
    for_each_character(text, [&](std::string_view bytes, std::optional<std::uint32_t> character) {
        valid += character ? bytes : kReplacement;
    });
    return valid;
}

std::string_view cut_utf8(std::string_view text, std::size_t max_bytes) {
    if (text.size() <= max_bytes) return text;
    std::size_t end = max_bytes;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u) --end;
    return text.substr(0, end);
}

std::string terminal_text(std::string_view text) {
    std::string shown;
    shown.reserve(text.size());
    for_each_character(text, [&](std::string_view bytes, std::optional<std::uint32_t> character) {
        if (!character) {
            for (const char byte : bytes) {
                shown += hexadecimal("\\x%02x", static_cast<unsigned char>(byte));
            }
        } else if (is_control(*character)) {
            shown += terminal_escape(*character);
        } else {
            shown += bytes;
        }
    });
    return shown;
}

std::string escape_json_controls(std::string json) {
    // Nearly all documents have nothing to escape, and some are megabytes long.
    const auto plain = [](char c) { return static_cast<unsigned char>(c) < 0x7F; };
    if (std::all_of(json.begin(), json.end(), plain)) return json;
    std::string escaped;
    escaped.reserve(json.size());
    for_each_character(json, [&](std::string_view bytes, std::optional<std::uint32_t> character) {
        // Line feeds here are those between fields.
        if (character && *character >= 0x20 && is_control(*character)) {
            escaped += json_escape(*character);
        } else {
            escaped += bytes;
        }
    });
    return escaped;
}

}  // namespace ossuary
