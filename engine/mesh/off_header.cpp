#include "engine/mesh/off_header.h"

#include <algorithm>
#include <string>

#include "engine/mesh/mesh_builder.h"

namespace ossuary::mesh {
namespace {

Error off_fault(const TextScanner& scanner, ErrorCode code, const std::string& text) {
    return at_line(scanner.line(), {code, text});
}

bool is_decimal_digit(char c) { return c >= '0' && c <= '9'; }

/// The header word taken apart: [ST][C][N][4][n]OFF, with whatever is glued to it.
struct HeaderWord {
    OffHeader header;
    std::size_t length = 0;  ///< up to the end of OFF
    bool recognised = false;
};

/// Files in the wild write it in any case. Only `nOFF` and `NOFF` are told apart by it: a small n
/// before OFF in capitals names the dimension, any other stands for normals.
HeaderWord split_header_word(std::string_view token) {
    HeaderWord word;
    const std::size_t prefixes = std::min(token.find_first_not_of("STCN4stcn"), token.size());
    const std::string_view off = token.substr(prefixes, 3);
    if (!spells(off, "OFF")) return word;
    std::size_t at = 0;
    const auto take = [&](std::string_view part) {
        if (!spells(token.substr(at, part.size()), part)) return false;
        at += part.size();
        return true;
    };
    // The prefixes have an order on paper that files in the wild do not keep.
    while (at < prefixes) {
        const bool names_dimension = token[at] == 'n' && off == "OFF";
        if (take("ST")) {
            word.header.has_texture_coordinates = true;
        } else if (take("C")) {
            word.header.has_colors = true;
        } else if (take("4")) {
            word.header.has_w = true;
        } else if (take("N")) {
            (names_dimension ? word.header.names_dimension : word.header.has_normals) = true;
        } else {
            return word;
        }
    }
    word.recognised = true;
    word.length = prefixes + off.size();
    return word;
}

/// What may be glued to the header word: counts, or what marks a binary file.
bool may_follow_word(std::string_view glued) {
    return glued.empty() || is_decimal_digit(glued[0]) || spells(glued, "BINARY");
}

/// Whether a single number is followed by a line of three counts.
bool is_from_qhull(TextScanner scanner) {
    constexpr std::uint64_t kMostDimensions = 9;  // of points as text it is their number
    std::uint64_t dimension = 0;
    if (scanner.read_count(dimension) != NumberStatus::kOk || dimension > kMostDimensions) {
        return false;
    }
    if (!scanner.at_line_end()) return false;
    std::uint64_t ignored = 0;
    if (!scanner.find_token()) return false;
    for (int count = 0; count < 3; ++count) {
        if (scanner.at_line_end() || scanner.read_count(ignored) != NumberStatus::kOk) return false;
    }
    return scanner.at_line_end();
}

/// Moves over braces and what they hold, from an opening one; false where none stands there.
bool skip_braces(TextScanner& scanner) {
    std::size_t depth = 0;
    while (scanner.find_token()) {
        for (const char c : scanner.peek_token()) {
            if (c != '{' && depth == 0) return false;
            scanner.advance(1);
            if (c == '{') ++depth;
            if (c == '}' && --depth == 0) return true;
        }
    }
    return false;
}

/// Moves over what OOGL allows before the header word (the Geomview manual, "Syntax Common to All
/// OOGL File Formats") and says how many braces it has opened.
std::size_t skip_oogl_preamble(TextScanner& scanner) {
    constexpr std::string_view kAppearance = "appearance";
    std::size_t open = 0;
    while (scanner.find_token()) {
        const std::string_view token = scanner.peek_token();
        if (token.starts_with('{') || token.starts_with('=')) {
            open += token[0] == '{' ? 1 : 0;
            scanner.advance(1);
        } else if (token.starts_with(kAppearance)) {
            TextScanner ahead = scanner;
            ahead.advance(kAppearance.size());
            if (!skip_braces(ahead)) break;
            scanner = ahead;
        } else if (token == "define") {
            scanner.advance(token.size());
            if (scanner.find_token()) scanner.advance(scanner.peek_token().size());
        } else {
            break;
        }
    }
    return open;
}

/// Reads the header word; false in `has_word` where the file starts with its counts.
Result<OffHeader> read_word(TextScanner& scanner) {
    const std::string_view token = scanner.peek_token();
    if (is_decimal_digit(token[0]) &&
        token.find_first_not_of("0123456789") == std::string_view::npos) {
        if (is_from_qhull(scanner)) {
            return off_fault(scanner, ErrorCode::kOffHeader,
                             "expected the header word OFF, found a dimension and counts as qhull "
                             "writes them with its option o, whose faces look in any direction");
        }
        OffHeader header;
        header.has_word = false;
        return header;
    }
    const HeaderWord word = split_header_word(token);
    const std::string_view glued = token.substr(word.length);
    if (!word.recognised || !may_follow_word(glued)) {
        return off_fault(scanner, ErrorCode::kOffHeader,
                         "expected the header word OFF, found " + quoted_token(token));
    }
    scanner.advance(word.length);
    if (!scanner.at_line_end() && spells(scanner.peek_token(), "BINARY")) {
        scanner.skip_line();
        OffHeader header = word.header;
        header.is_binary = true;
        return header;
    }
    if (word.header.names_dimension) {
        std::uint64_t dimension = 0;
        if (!scanner.find_token() || scanner.read_count(dimension) != NumberStatus::kOk) {
            return off_fault(scanner, ErrorCode::kOffDimension,
                             "expected the number of dimensions after " + quoted_token(token));
        }
        if (dimension != 3) {
            return off_fault(scanner, ErrorCode::kOffDimension,
                             "expected three dimensions, found " + std::to_string(dimension));
        }
    }
    return word.header;
}

Result<std::uint64_t> read_one_count(TextScanner& scanner, std::string_view what) {
    const std::string expected = "expected the number of " + std::string(what) + ", found ";
    if (!scanner.find_token()) {
        return off_fault(scanner, ErrorCode::kOffCounts, expected + "the end of the file");
    }
    std::uint64_t count = 0;
    switch (scanner.read_count(count)) {
        case NumberStatus::kOk:
            return count;
        case NumberStatus::kTooLarge:  // far above any cap, which then names the limit
            scanner.advance(scanner.peek_token().size());
            return std::numeric_limits<std::uint64_t>::max();
        default:
            return off_fault(scanner, ErrorCode::kOffCounts,
                             expected + quoted_token(scanner.peek_token()));
    }
}

bool is_integer(std::string_view token) {
    if (!token.empty() && (token[0] == '-' || token[0] == '+')) token.remove_prefix(1);
    return !token.empty() && token.find_first_not_of("0123456789") == std::string_view::npos;
}

/// The number of edges is never used, may be wrong, and is missing in some files: it is there if an
/// integer follows on the line of the counts, or stands alone on the next line with content.
Result<bool> skip_edge_count(TextScanner& scanner) {
    TextScanner ahead = scanner;
    const bool same_line = !ahead.at_line_end();
    if (!ahead.find_token()) return false;
    const std::string_view token = ahead.peek_token();
    if (!is_integer(token)) {
        if (!same_line) return false;
        return off_fault(ahead, ErrorCode::kOffCounts,
                         "expected the number of edges, found " + quoted_token(token));
    }
    ahead.advance(token.size());
    if (!same_line && !ahead.at_line_end()) return false;
    scanner = ahead;
    return true;
}

}  // namespace

Result<OffHeader> read_off_header(TextScanner& scanner) {
    scanner.skip_byte_order_mark();
    skip_oogl_preamble(scanner);
    if (!scanner.find_token()) {
        return off_fault(scanner, ErrorCode::kOffHeader,
                         "expected the header word OFF, found the end of the file");
    }
    Result<OffHeader> header = read_word(scanner);
    if (!header || header->is_binary) return header;

    const Result<std::uint64_t> vertices = read_one_count(scanner, "vertices");
    if (!vertices) return vertices.error();
    header->counts_line = scanner.line();
    const Result<std::uint64_t> faces = read_one_count(scanner, "faces");
    if (!faces) return faces.error();
    const Result<bool> edges = skip_edge_count(scanner);
    if (!edges) return edges.error();
    header->vertices = *vertices;
    header->faces = *faces;
    header->has_edge_count = *edges;
    return header;
}

std::string_view without_closing_braces(std::string_view text) {
    TextScanner scanner(text);
    scanner.skip_byte_order_mark();
    for (std::size_t open = skip_oogl_preamble(scanner); open > 0; --open) {
        const std::size_t last = text.rfind('}');
        if (last == std::string_view::npos) break;
        TextScanner after(text.substr(last + 1));
        if (after.find_token()) break;
        text = text.substr(0, last);
    }
    return text;
}

bool looks_like_off(std::string_view text) {
    TextScanner scanner(text);
    scanner.skip_byte_order_mark();
    const bool in_braces = skip_oogl_preamble(scanner) > 0;
    if (!scanner.find_token()) return false;
    const std::string_view token = scanner.peek_token();
    const HeaderWord word = split_header_word(token);
    if (word.recognised && may_follow_word(token.substr(word.length))) return true;
    constexpr std::size_t kLongestPrefix = 6;  // STCN4n; a misspelt one is told so
    if (token.find("OFF") <= kLongestPrefix) return true;
    if (in_braces) return false;
    if (is_from_qhull(scanner)) return true;
    for (int count = 0; count < 3; ++count) {
        std::uint64_t ignored = 0;
        if (scanner.at_line_end() || scanner.read_count(ignored) != NumberStatus::kOk) return false;
    }
    return scanner.at_line_end();
}

}  // namespace ossuary::mesh
