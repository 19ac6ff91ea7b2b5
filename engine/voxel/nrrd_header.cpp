#include "engine/voxel/nrrd_header.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/mesh/text_scanner.h"
#include "engine/voxel/volume_parts.h"

namespace ossuary::voxel {
namespace {

constexpr std::size_t kMostAxes = 16;  // NRRD_DIM_MAX

struct TypeName {
    std::string_view name;
    VoxelType type;
};
constexpr TypeName kTypeNames[] = {{"signed char", VoxelType::kInt8},
                                   {"int8", VoxelType::kInt8},
                                   {"int8_t", VoxelType::kInt8},
                                   {"uchar", VoxelType::kUint8},
                                   {"unsigned char", VoxelType::kUint8},
                                   {"uint8", VoxelType::kUint8},
                                   {"uint8_t", VoxelType::kUint8},
                                   {"short", VoxelType::kInt16},
                                   {"short int", VoxelType::kInt16},
                                   {"signed short", VoxelType::kInt16},
                                   {"signed short int", VoxelType::kInt16},
                                   {"int16", VoxelType::kInt16},
                                   {"int16_t", VoxelType::kInt16},
                                   {"ushort", VoxelType::kUint16},
                                   {"unsigned short", VoxelType::kUint16},
                                   {"unsigned short int", VoxelType::kUint16},
                                   {"uint16", VoxelType::kUint16},
                                   {"uint16_t", VoxelType::kUint16},
                                   {"int", VoxelType::kInt32},
                                   {"signed int", VoxelType::kInt32},
                                   {"int32", VoxelType::kInt32},
                                   {"int32_t", VoxelType::kInt32},
                                   {"uint", VoxelType::kUint32},
                                   {"unsigned int", VoxelType::kUint32},
                                   {"uint32", VoxelType::kUint32},
                                   {"uint32_t", VoxelType::kUint32},
                                   {"longlong", VoxelType::kInt64},
                                   {"long long", VoxelType::kInt64},
                                   {"long long int", VoxelType::kInt64},
                                   {"signed long long", VoxelType::kInt64},
                                   {"signed long long int", VoxelType::kInt64},
                                   {"int64", VoxelType::kInt64},
                                   {"int64_t", VoxelType::kInt64},
                                   {"ulonglong", VoxelType::kUint64},
                                   {"unsigned long long", VoxelType::kUint64},
                                   {"unsigned long long int", VoxelType::kUint64},
                                   {"uint64", VoxelType::kUint64},
                                   {"uint64_t", VoxelType::kUint64},
                                   {"float", VoxelType::kFloat32},
                                   {"double", VoxelType::kFloat64}};

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return lower;
}

/// Words that are separated by blanks.
std::vector<std::string_view> words_of(std::string_view text) {
    std::vector<std::string_view> words;
    while (words.size() <= kMostAxes) {
        text = trimmed(text);
        if (text.empty()) break;
        const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
        words.push_back(text.substr(0, end));
        text.remove_prefix(end);
    }
    return words;
}

std::optional<double> real_of(std::string_view word) {
    word = trimmed(word);
    const mesh::ParsedNumber<double> parsed =
        mesh::parse_double(word.data(), word.data() + word.size());
    const bool whole =
        parsed.status == mesh::NumberStatus::kOk && parsed.end == word.data() + word.size();
    return whole ? std::optional(parsed.value) : std::nullopt;
}

std::optional<std::int64_t> integer_of(std::string_view word) {
    const std::optional<double> value = real_of(word);
    constexpr double kLargest = 1e15;
    if (!value || *value != std::floor(*value) || std::abs(*value) > kLargest) return std::nullopt;
    return static_cast<std::int64_t>(*value);
}

/// "(1,0,0)" as a vector.
std::optional<Vec3> vector_of(std::string_view word) {
    word = trimmed(word);
    if (!word.starts_with('(') || !word.ends_with(')')) return std::nullopt;
    word = word.substr(1, word.size() - 2);
    Vec3 vector;
    for (int axis = 0; axis < 3; ++axis) {
        const std::size_t comma = word.find(',');
        if ((comma == std::string_view::npos) != (axis == 2)) return std::nullopt;
        const std::optional<double> value = real_of(word.substr(0, comma));
        if (!value) return std::nullopt;
        vector[axis] = *value;
        if (axis < 2) word.remove_prefix(comma + 1);
    }
    return vector;
}

/// Vectors and `none`, which may have blanks within their brackets.
std::optional<std::vector<std::optional<Vec3>>> vectors_of(std::string_view text) {
    std::vector<std::optional<Vec3>> vectors;
    for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
        if (vectors.size() == kMostAxes) return std::nullopt;
        if (lower_case(text.substr(0, 4)) == "none") {
            vectors.emplace_back();
            text.remove_prefix(4);
            continue;
        }
        const std::size_t end = text.find(')');
        if (end == std::string_view::npos) return std::nullopt;
        const std::optional<Vec3> vector = vector_of(text.substr(0, end + 1));
        if (!vector) return std::nullopt;
        vectors.emplace_back(vector);
        text.remove_prefix(end + 1);
    }
    return vectors;
}

class HeaderReader {
public:
    explicit HeaderReader(std::string_view bytes) : bytes_(bytes) {}
    Result<NrrdHeader> read();

private:
    [[nodiscard]] Error invalid(const std::string& what) const {
        return {ErrorCode::kNrrdInvalid, "line " + std::to_string(line_) + ": " + what};
    }
    [[nodiscard]] std::optional<std::string_view> next_line();
    Result<void> read_field(const std::string& key, std::string_view value);
    Result<void> read_sizes(std::string_view value);
    Result<void> read_spacings(std::string_view value);
    Result<void> read_directions(std::string_view value);
    Result<void> read_encoding(std::string_view value);
    Result<NrrdHeader> finish();

    std::string_view bytes_;
    std::size_t at_ = 0;
    std::size_t line_ = 0;
    NrrdHeader header_;
    bool has_type_ = false, has_encoding_ = false, has_order_ = false;
    std::size_t dimension_ = 0;
    std::vector<std::uint64_t> sizes_;
    std::vector<double> spacings_;  ///< 1 where the file does not say
    std::vector<std::optional<Vec3>> directions_;
};

/// None at the end of the file, or where the line is not one of a header.
std::optional<std::string_view> HeaderReader::next_line() {
    constexpr std::size_t kLongestLine = 65'536;
    const std::string_view rest = bytes_.substr(at_, kLongestLine);
    const std::size_t end = rest.find('\n');
    if (end == std::string_view::npos) return std::nullopt;
    at_ += end + 1;
    ++line_;
    std::string_view line = rest.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

Result<void> HeaderReader::read_sizes(std::string_view value) {
    for (const std::string_view word : words_of(value)) {
        const std::optional<std::int64_t> size = integer_of(word);
        if (!size || *size < 1) {
            return invalid("sizes: expected whole numbers above 0, found " +
                           mesh::quoted_token(word));
        }
        sizes_.push_back(static_cast<std::uint64_t>(*size));
    }
    return {};
}

Result<void> HeaderReader::read_spacings(std::string_view value) {
    for (const std::string_view word : words_of(value)) {
        if (lower_case(word) == "nan") {
            spacings_.push_back(1.0);
            continue;
        }
        const std::optional<double> spacing = real_of(word);
        if (!spacing || *spacing == 0.0) {
            return invalid("spacings: expected numbers other than 0, found " +
                           mesh::quoted_token(word));
        }
        spacings_.push_back(std::abs(*spacing));
    }
    return {};
}

Result<void> HeaderReader::read_directions(std::string_view value) {
    auto vectors = vectors_of(value);
    if (!vectors) {
        return invalid("space directions: expected vectors of three numbers, or none, found " +
                       mesh::quoted_token(value));
    }
    directions_ = *std::move(vectors);
    return {};
}

Result<void> HeaderReader::read_encoding(std::string_view value) {
    const std::string word = lower_case(value);
    has_encoding_ = true;
    if (word == "raw") {
        header_.encoding = NrrdEncoding::kRaw;
    } else if (word == "txt" || word == "text" || word == "ascii") {
        header_.encoding = NrrdEncoding::kText;
    } else if (word == "gz" || word == "gzip") {
        header_.encoding = NrrdEncoding::kGzip;
    } else {
        return invalid("encoding: expected raw, ascii or gzip, found " + mesh::quoted_token(value));
    }
    return {};
}

Result<void> HeaderReader::read_field(const std::string& key, std::string_view value) {
    if (key == "data file" || key == "datafile") {
        return {ErrorCode::kVolumeDetached,
                "line " + std::to_string(line_) +
                    ": expected the values in the same file, found them "
                    "in " +
                    mesh::quoted_token(value)};
    }
    if (key == "sizes") return read_sizes(value);
    if (key == "spacings") return read_spacings(value);
    if (key == "space directions") return read_directions(value);
    if (key == "encoding") return read_encoding(value);
    if (key == "type") {
        const std::string name = lower_case(value);
        const auto* const found =
            std::find_if(std::begin(kTypeNames), std::end(kTypeNames),
                         [&](const TypeName& each) { return each.name == name; });
        if (found == std::end(kTypeNames)) {
            return invalid("type: expected an integer or real type, found " +
                           mesh::quoted_token(value));
        }
        header_.type = found->type;
        has_type_ = true;
    } else if (key == "endian") {
        const std::string word = lower_case(value);
        if (word != "little" && word != "big") {
            return invalid("endian: expected little or big, found " + mesh::quoted_token(value));
        }
        header_.order = word == "big" ? std::endian::big : std::endian::little;
        has_order_ = true;
    } else if (key == "space origin") {
        const std::optional<Vec3> origin = vector_of(value);
        if (!origin) {
            return invalid("space origin: expected a vector of three numbers, found " +
                           mesh::quoted_token(value));
        }
        header_.origin = *origin;
    } else if (key == "dimension" || key == "line skip" || key == "lineskip" ||
               key == "byte skip" || key == "byteskip") {
        const std::optional<std::int64_t> number = integer_of(value);
        const bool may_be_less = key.starts_with("byte");
        if (!number || *number < (may_be_less ? -1 : 0)) {
            return invalid(key + ": expected a whole number, found " + mesh::quoted_token(value));
        }
        if (key == "dimension") {
            dimension_ = static_cast<std::size_t>(*number);
        } else if (may_be_less) {
            header_.byte_skip = *number;
        } else {
            header_.line_skip = static_cast<std::uint64_t>(*number);
        }
    } else if (key == "space units") {
        std::erase_if(header_.unit = std::string(words_of(value).empty() ? "" : words_of(value)[0]),
                      [](char c) { return c == '"'; });
        if (header_.unit != "m" && header_.unit != "mm" && header_.unit != "um") {
            header_.unit.clear();
        }
    }
    return {};
}

/// Puts together what the fields say of the three axes; further ones may have a single sample.
Result<NrrdHeader> HeaderReader::finish() {
    if (!has_type_ || !has_encoding_ || sizes_.empty() || dimension_ == 0) {
        return invalid("expected the fields type, dimension, sizes and encoding before the data");
    }
    if (sizes_.size() != dimension_ || dimension_ > kMostAxes) {
        return invalid("expected " + std::to_string(dimension_) + " sizes, found " +
                       std::to_string(sizes_.size()));
    }
    if (!has_order_ && header_.encoding != NrrdEncoding::kText && size_of(header_.type) > 1) {
        return invalid("expected the field endian, as values take several bytes");
    }
    if ((!spacings_.empty() && spacings_.size() != dimension_) ||
        (!directions_.empty() && directions_.size() != dimension_)) {
        return invalid("expected spacings and space directions for " + std::to_string(dimension_) +
                       " axes");
    }
    std::vector<std::size_t> axes;
    for (std::size_t axis = 0; axis < dimension_; ++axis) {
        const bool may_go = sizes_[axis] == 1 && dimension_ - axis + axes.size() > 3;
        if (!may_go) axes.push_back(axis);
    }
    if (axes.size() != 3) {
        return invalid("expected three axes of more than one sample, found " +
                       std::to_string(axes.size()));
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const auto column = static_cast<Eigen::Index>(i);
        header_.sides[i] = sizes_[axes[i]];
        if (!spacings_.empty()) header_.axes.col(column) *= spacings_[axes[i]];
        if (directions_.empty()) continue;
        if (!directions_[axes[i]]) return invalid("expected a direction for each axis, found none");
        header_.axes.col(column) = *directions_[axes[i]];
    }
    if (!is_usable_frame(header_.origin, header_.axes)) {
        return invalid("expected space directions that span space");
    }
    header_.bytes = at_;
    return std::move(header_);
}

Result<NrrdHeader> HeaderReader::read() {
    constexpr std::size_t kMostLines = 10'000;
    const std::optional<std::string_view> magic = next_line();
    if (!magic || magic->size() != 8 || !magic->starts_with("NRRD000") || (*magic)[7] < '1' ||
        (*magic)[7] > '5') {
        line_ = 1;
        return invalid("expected NRRD0001 to NRRD0005");
    }
    while (line_ < kMostLines) {
        const std::optional<std::string_view> line = next_line();
        if (!line) return invalid("expected an empty line before the data, found none");
        if (line->empty()) return finish();
        if (line->starts_with('#')) continue;
        const std::size_t colon = line->find(':');
        if (colon == std::string_view::npos) {
            return invalid("expected a field, found " + mesh::quoted_token(*line));
        }
        if (line->substr(colon).starts_with(":=")) continue;  // a note of the user's
        const Result<void> read = read_field(lower_case(trimmed(line->substr(0, colon))),
                                             trimmed(line->substr(colon + 1)));
        if (!read) return read.error();
    }
    return invalid("expected at most " + std::to_string(kMostLines) + " lines of header");
}

}  // namespace

Result<NrrdHeader> read_nrrd_header(std::string_view bytes) { return HeaderReader(bytes).read(); }

}  // namespace ossuary::voxel
