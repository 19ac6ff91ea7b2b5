#include "index/report_text.h"

#include <array>
#include <charconv>
#include <cmath>

#include "engine/core/text.h"

namespace ossuary::index {

namespace {

/// `text` with U+FFFD for what no XML document may hold, not even as a reference (XML 1.0, sec.
/// 2.2): control characters, U+FFFE and U+FFFF.
std::string characters_of_xml(std::string_view text) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        const std::string_view three = text.substr(i, 3);
        if (c >= 0 && c < 0x20 && c != '\t' && c != '\n' && c != '\r') {
            out += "\xEF\xBF\xBD";
        } else if (three == "\xEF\xBF\xBE" || three == "\xEF\xBF\xBF") {
            out += "\xEF\xBF\xBD";
            i += 2;
        } else {
            out += c;
        }
    }
    return out;
}

}  // namespace

std::string markup_text(std::string_view text) {
    std::string out;
    for (const char c : characters_of_xml(valid_utf8(text))) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            default:
                out += c;
        }
    }
    return out;
}

std::string csv_field(std::string_view text) {
    std::string valid = valid_utf8(text);
    if (valid.find_first_of(",\"\r\n") == std::string::npos) return valid;
    std::string out = "\"";
    for (const char c : valid) {
        if (c == '"') out += '"';
        out += c;
    }
    return out + "\"";
}

std::string fixed(double value, int digits) {
    if (!std::isfinite(value)) return "";
    std::array<char, 400> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                   std::chars_format::fixed, digits)
                         .ptr;
    return {text.data(), end};
}

std::string shortest(double value) {
    if (!std::isfinite(value)) return "";
    std::array<char, 64> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return {text.data(), end};
}

std::string evaluation_title(const Evaluation& evaluation) {
    std::string title(to_string(evaluation.ranker));
    if (evaluation.rerank) title += ", re-ranked";
    return title;
}

}  // namespace ossuary::index
