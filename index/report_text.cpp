#include "index/report_text.h"

#include <array>
#include <charconv>
#include <cmath>

namespace ossuary::index {

std::string markup_text(std::string_view text) {
    std::string out;
    for (const char c : text) {
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
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
    std::string out = "\"";
    for (const char c : text) {
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
