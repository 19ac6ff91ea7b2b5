#include "engine/mesh/ply_header.h"

#include <array>
#include <cassert>
#include <optional>
#include <utility>

#include "engine/mesh/mesh_builder.h"
#include "engine/mesh/text_scanner.h"

namespace ossuary::mesh {
namespace {

std::optional<PlyType> ply_type(std::string_view word) {
    constexpr std::array<std::pair<std::string_view, PlyType>, 16> kTypes = {{
        {"char", PlyType::kInt8},
        {"int8", PlyType::kInt8},
        {"uchar", PlyType::kUint8},
        {"uint8", PlyType::kUint8},
        {"short", PlyType::kInt16},
        {"int16", PlyType::kInt16},
        {"ushort", PlyType::kUint16},
        {"uint16", PlyType::kUint16},
        {"int", PlyType::kInt32},
        {"int32", PlyType::kInt32},
        {"uint", PlyType::kUint32},
        {"uint32", PlyType::kUint32},
        {"float", PlyType::kFloat32},
        {"float32", PlyType::kFloat32},
        {"double", PlyType::kFloat64},
        {"float64", PlyType::kFloat64},
    }};
    for (const auto& [name, type] : kTypes) {
        if (name == word) return type;
    }
    return std::nullopt;
}

PlyMeaning meaning_of(const PlyProperty& property) {
    if (property.is_list) {
        const bool corners = property.name == "vertex_indices" || property.name == "vertex_index";
        return corners ? PlyMeaning::kCorners : PlyMeaning::kOther;
    }
    constexpr std::array<std::pair<std::string_view, PlyMeaning>, 9> kNames = {
        {{"x", PlyMeaning::kX},
         {"y", PlyMeaning::kY},
         {"z", PlyMeaning::kZ},
         {"red", PlyMeaning::kRed},
         {"green", PlyMeaning::kGreen},
         {"blue", PlyMeaning::kBlue},
         {"diffuse_red", PlyMeaning::kRed},
         {"diffuse_green", PlyMeaning::kGreen},
         {"diffuse_blue", PlyMeaning::kBlue}}};
    for (const auto& [name, meaning] : kNames) {
        if (property.name == name) return meaning;
    }
    return PlyMeaning::kOther;
}

class PlyHeaderReader {
public:
    explicit PlyHeaderReader(std::string_view bytes) : bytes_(bytes) {
        const std::size_t first = bytes.find_first_of("\r\n");
        const bool lone_cr = first != std::string_view::npos && bytes[first] == '\r' &&
                             !bytes.substr(first).starts_with("\r\n");
        newline_ = lone_cr ? '\r' : '\n';
    }

    Result<PlyHeader> read();

private:
    bool next_line();
    std::string_view next_word();
    [[nodiscard]] Error fail(const std::string& expected, std::string_view found) const {
        return at_line(header_.lines, {ErrorCode::kPlyHeader,
                                       "expected " + expected + ", found " + quoted_token(found)});
    }
    Result<void> read_format();
    Result<void> read_element();
    Result<void> read_property();
    Result<PlyType> read_type();

    std::string_view bytes_;
    char newline_ = '\n';
    std::string_view rest_;  // of the line
    PlyHeader header_;
    bool has_format_ = false;
};

bool PlyHeaderReader::next_line() {
    const std::size_t end = bytes_.find(newline_, header_.bytes);
    if (end == std::string_view::npos) return false;
    rest_ = bytes_.substr(header_.bytes, end - header_.bytes);
    header_.bytes = end + 1;
    ++header_.lines;
    return true;
}

/// Empty at the end of the line.
std::string_view PlyHeaderReader::next_word() {
    constexpr std::string_view kBlanks = " \t\r";
    rest_.remove_prefix(std::min(rest_.find_first_not_of(kBlanks), rest_.size()));
    const std::string_view word = rest_.substr(0, rest_.find_first_of(kBlanks));
    rest_.remove_prefix(word.size());
    return word;
}

Result<void> PlyHeaderReader::read_format() {
    const std::string_view word = next_word();
    has_format_ = true;
    if (word == "ascii") {
        header_.encoding = PlyEncoding::kText;
    } else if (word == "binary_little_endian") {
        header_.encoding = PlyEncoding::kLittleEndian;
    } else if (word == "binary_big_endian") {
        header_.encoding = PlyEncoding::kBigEndian;
    } else {
        return fail("ascii, binary_little_endian or binary_big_endian", word);
    }
    return {};
}

Result<void> PlyHeaderReader::read_element() {
    PlyElement element;
    element.name = next_word();
    element.line = header_.lines;
    const std::string_view count = next_word();
    TextScanner scanner(count);
    switch (scanner.read_count(element.count)) {
        case NumberStatus::kOk:
            break;
        case NumberStatus::kTooLarge:  // far above any cap, which then names the limit
            element.count = std::numeric_limits<std::uint64_t>::max();
            break;
        default:
            return fail("the number of elements", count);
    }
    for (const PlyElement& other : header_.elements) {
        if (other.name == element.name) return fail("each element once", element.name);
    }
    header_.elements.push_back(std::move(element));
    return {};
}

Result<PlyType> PlyHeaderReader::read_type() {
    const std::string_view word = next_word();
    if (const auto type = ply_type(word)) return *type;
    return fail("a type (char, uchar, short, ushort, int, uint, float, double)", word);
}

Result<void> PlyHeaderReader::read_property() {
    if (header_.elements.empty()) return fail("an element before its properties", "property");
    PlyProperty property;
    const std::string_view before = rest_;
    property.is_list = next_word() == "list";
    if (property.is_list) {
        const Result<PlyType> count_type = read_type();
        if (!count_type) return count_type.error();
        property.count_type = *count_type;
    } else {
        rest_ = before;
    }
    const Result<PlyType> type = read_type();
    if (!type) return type.error();
    property.type = *type;
    property.name = next_word();
    if (property.name.empty()) return fail("the name of the property", "");
    property.meaning = meaning_of(property);
    header_.elements.back().properties.push_back(std::move(property));
    return {};
}

Result<PlyHeader> PlyHeaderReader::read() {
    next_line();  // ply
    while (next_line()) {
        const std::string_view word = next_word();
        Result<void> read;
        if (word == "format") {
            read = read_format();
        } else if (word == "element") {
            read = read_element();
        } else if (word == "property") {
            read = read_property();
        } else if (word == "end_header") {
            if (!has_format_) return fail("a line format", word);
            return std::move(header_);
        } else if (!word.empty() && word != "comment" && word != "obj_info") {
            read = fail("format, element, property, comment, obj_info or end_header", word);
        }
        if (!read) return read.error();
    }
    return at_line(header_.lines,
                   {ErrorCode::kPlyHeader, "expected end_header, found the end of the file"});
}

}  // namespace

std::size_t size_of(PlyType type) {
    switch (type) {
        case PlyType::kInt8:
        case PlyType::kUint8:
            return 1;
        case PlyType::kInt16:
        case PlyType::kUint16:
            return 2;
        case PlyType::kInt32:
        case PlyType::kUint32:
        case PlyType::kFloat32:
            return 4;
        case PlyType::kFloat64:
            return 8;
    }
    assert(false);
    return 0;
}

bool looks_like_ply(std::string_view bytes) {
    if (!bytes.starts_with("ply")) return false;
    const std::size_t end = bytes.find_first_not_of(" \t", 3);
    return end != std::string_view::npos && (bytes[end] == '\n' || bytes[end] == '\r');
}

Result<PlyHeader> read_ply_header(std::string_view bytes) { return PlyHeaderReader(bytes).read(); }

}  // namespace ossuary::mesh
