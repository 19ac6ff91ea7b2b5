#include "engine/voxel/npy.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <cstring>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "engine/core/whole_file.h"
#include "engine/voxel/volume_values.h"

namespace ossuary::voxel {
namespace {

constexpr std::string_view kMagic("\x93NUMPY", 6);
constexpr std::size_t kMaxHeader = 1u << 16;

struct Header {
    std::string descr;
    bool fortran_order = false;
    std::vector<std::uint64_t> shape;
};

/// Reads the one dictionary that the format allows: three known keys, each once, in any order.
class HeaderParser {
public:
    explicit HeaderParser(std::string_view text) : rest_(text) {}

    /// The header, or what was wrong with it in `problem()`.
    std::optional<Header> parse() {
        Header header;
        bool has_descr = false, has_order = false, has_shape = false;
        if (!take('{')) return fail("expected '{'");
        while (!take('}')) {
            std::string key;
            if (!string_literal(key)) return fail("expected a quoted key or '}'");
            if (!take(':')) return fail("expected ':' after '" + key + "'");
            bool ok = false;
            if (key == "descr" && !std::exchange(has_descr, true)) {
                ok = string_literal(header.descr);
            } else if (key == "fortran_order" && !std::exchange(has_order, true)) {
                ok = boolean(header.fortran_order);
            } else if (key == "shape" && !std::exchange(has_shape, true)) {
                ok = tuple(header.shape);
            } else {
                return fail("unexpected or repeated key '" + key + "'");
            }
            if (!ok) return fail("the value of '" + key + "' is not of the expected kind");
            if (!take(',')) {
                if (take('}')) break;
                return fail("expected ',' or '}'");
            }
        }
        skip_space();
        if (!rest_.empty()) return fail("text after the closing '}'");
        if (!has_descr || !has_order || !has_shape) {
            return fail("expected the keys descr, fortran_order and shape");
        }
        return header;
    }

    [[nodiscard]] const std::string& problem() const { return problem_; }

private:
    std::optional<Header> fail(std::string problem) {
        problem_ = std::move(problem);
        return std::nullopt;
    }
    void skip_space() {
        while (!rest_.empty() && (rest_.front() == ' ' || rest_.front() == '\n')) {
            rest_.remove_prefix(1);
        }
    }
    bool take(char c) {
        skip_space();
        if (rest_.empty() || rest_.front() != c) return false;
        rest_.remove_prefix(1);
        return true;
    }
    bool string_literal(std::string& out) {
        skip_space();
        if (rest_.empty() || (rest_.front() != '\'' && rest_.front() != '"')) return false;
        const std::size_t end = rest_.find(rest_.front(), 1);
        if (end == std::string_view::npos) return false;
        out = rest_.substr(1, end - 1);
        rest_.remove_prefix(end + 1);
        return out.find('\\') == std::string::npos;
    }
    bool boolean(bool& out) {
        skip_space();
        for (const auto& [word, value] : {std::pair<std::string_view, bool>{"True", true},
                                          std::pair<std::string_view, bool>{"False", false}}) {
            if (!rest_.starts_with(word)) continue;
            rest_.remove_prefix(word.size());
            out = value;
            return true;
        }
        return false;
    }
    bool tuple(std::vector<std::uint64_t>& out) {
        if (!take('(')) return false;
        while (!take(')')) {
            std::uint64_t value = 0;
            if (!number(value) || out.size() == 32) return false;
            out.push_back(value);
            if (!take(',')) return take(')');
        }
        return true;
    }
    bool number(std::uint64_t& out) {
        skip_space();
        std::size_t digits = 0;
        out = 0;
        while (digits < rest_.size() && rest_[digits] >= '0' && rest_[digits] <= '9') {
            if (digits == 18) return false;
            out = out * 10 + static_cast<std::uint64_t>(rest_[digits++] - '0');
        }
        rest_.remove_prefix(digits);
        return digits > 0;
    }

    std::string_view rest_;
    std::string problem_;
};

std::string shape_text(const std::vector<std::uint64_t>& shape) {
    std::string text = "(";
    for (std::size_t i = 0; i < shape.size(); ++i) {
        text += (i > 0 ? ", " : "") + std::to_string(shape[i]);
    }
    return text + ")";
}

/// The header's text; what follows it is left in `bytes`.
Result<std::string_view> split_header(std::string_view& bytes, const std::string& where) {
    const auto invalid = [&](const std::string& what) {
        return Error{ErrorCode::kNpyInvalid, where + what};
    };
    if (!bytes.starts_with(kMagic)) return invalid("expected the magic \\x93NUMPY at the start");
    if (bytes.size() < 8) return invalid("the file ends within the version");
    const auto byte = [&](std::size_t i) {
        return static_cast<std::size_t>(static_cast<unsigned char>(bytes[i]));
    };
    const std::size_t major = byte(6);
    if (major < 1 || major > 3 || byte(7) != 0) {
        return invalid("found version " + std::to_string(major) + "." + std::to_string(byte(7)) +
                       ", expected 1.0, 2.0 or 3.0");
    }
    const std::size_t length_bytes = major == 1 ? 2 : 4;
    if (bytes.size() < 8 + length_bytes) return invalid("the file ends within the header's length");
    std::size_t length = 0;
    for (std::size_t i = 0; i < length_bytes; ++i) length |= byte(8 + i) << (8 * i);
    if (length > kMaxHeader) {
        return invalid("found a header of " + std::to_string(length) + " bytes, expected at most " +
                       std::to_string(kMaxHeader));
    }
    const std::size_t start = 8 + length_bytes;
    if (bytes.size() - start < length) return invalid("the file ends within the header");
    const std::string_view text = bytes.substr(start, length);
    bytes.remove_prefix(start + length);
    return text;
}

struct NpyType {
    std::string_view descr;
    VoxelType type;
    std::endian order = std::endian::little;
};
constexpr std::array<NpyType, 7> kByteTypes = {{{"|b1", VoxelType::kUint8},
                                                {"|u1", VoxelType::kUint8},
                                                {"|i1", VoxelType::kInt8},
                                                {"<u1", VoxelType::kUint8},
                                                {"<i1", VoxelType::kInt8},
                                                {"=u1", VoxelType::kUint8},
                                                {"?", VoxelType::kUint8}}};
constexpr std::array<NpyType, 16> kWiderTypes = {{{"<u2", VoxelType::kUint16},
                                                  {"<i2", VoxelType::kInt16},
                                                  {"<u4", VoxelType::kUint32},
                                                  {"<i4", VoxelType::kInt32},
                                                  {"<u8", VoxelType::kUint64},
                                                  {"<i8", VoxelType::kInt64},
                                                  {"<f4", VoxelType::kFloat32},
                                                  {"<f8", VoxelType::kFloat64},
                                                  {">u2", VoxelType::kUint16, std::endian::big},
                                                  {">i2", VoxelType::kInt16, std::endian::big},
                                                  {">u4", VoxelType::kUint32, std::endian::big},
                                                  {">i4", VoxelType::kInt32, std::endian::big},
                                                  {">u8", VoxelType::kUint64, std::endian::big},
                                                  {">i8", VoxelType::kInt64, std::endian::big},
                                                  {">f4", VoxelType::kFloat32, std::endian::big},
                                                  {">f8", VoxelType::kFloat64, std::endian::big}}};

/// Null where there is no such type, or none of one byte.
const NpyType* type_of(std::string_view descr, bool bytes_only) {
    const auto find = [&](const auto& types) -> const NpyType* {
        for (const NpyType& type : types) {
            if (type.descr == descr) return &type;
        }
        return nullptr;
    };
    const NpyType* const byte_type = find(kByteTypes);
    return byte_type != nullptr || bytes_only ? byte_type : find(kWiderTypes);
}

Result<Vec3i> size_of_shape(const std::vector<std::uint64_t>& shape, const std::string& where,
                            const NpyOptions& options) {
    if (shape.size() != 3 || std::find(shape.begin(), shape.end(), 0u) != shape.end()) {
        return {ErrorCode::kNpyInvalid, where + "found the shape " + shape_text(shape) +
                                            ", expected three sides of at least 1"};
    }
    std::uint64_t voxels = 1;
    for (const std::uint64_t side : shape) {
        if (side > static_cast<std::uint64_t>(options.max_side) ||
            voxels > options.max_voxels / side) {
            return {ErrorCode::kVolumeTooLarge,
                    where + "found the shape " + shape_text(shape) + ", expected at most " +
                        std::to_string(options.max_side) + " a side and " +
                        std::to_string(options.max_voxels) + " voxels"};
        }
        voxels *= side;
    }
    return Vec3i(static_cast<int>(shape[0]), static_cast<int>(shape[1]),
                 static_cast<int>(shape[2]));
}

Result<Volume> parse_array(std::string_view bytes, std::string_view name, const NpyOptions& options,
                           bool bytes_only) {
    const std::string where = std::string(name) + ": ";
    auto text = split_header(bytes, where);
    if (!text) return text.error();
    HeaderParser parser(*text);
    const std::optional<Header> header = parser.parse();
    if (!header) return {ErrorCode::kNpyInvalid, where + "header: " + parser.problem()};
    const NpyType* const type = type_of(header->descr, bytes_only);
    if (type == nullptr) {
        return {ErrorCode::kNpyInvalid,
                where + "found the type '" + header->descr + "', expected " +
                    (bytes_only ? "bool, uint8 or int8 (|b1, |u1, |i1)"
                                : "bool, an integer or a real number of 4 or 8 bytes")};
    }
    const Result<Vec3i> size = size_of_shape(header->shape, where, options);
    if (!size) return size.error();
    Volume volume;
    volume.size = *size;
    volume.type = type->type;
    volume.order = type->order;
    volume.last_axis_fastest = !header->fortran_order;
    volume.origin = Vec3::Constant(0.5);
    const std::uint64_t expected = volume.voxel_count() * size_of(volume.type);
    if (bytes.size() != expected) {
        return {ErrorCode::kNpyInvalid,
                where + "found " + std::to_string(bytes.size()) + " bytes of values, expected " +
                    std::to_string(expected) + " for the shape " + shape_text(header->shape)};
    }
    volume.values = bytes;
    return volume;
}

}  // namespace

Result<Volume> read_npy_volume(std::string_view bytes, std::string_view name,
                               const VolumeOptions& options, const std::stop_token&) {
    return parse_array(bytes, name, {options.max_voxels, options.max_side}, false);
}

Result<BitVolume> parse_npy(std::string_view bytes, std::string_view name,
                            const NpyOptions& options) {
    const Result<Volume> array = parse_array(bytes, name, options, true);
    if (!array) return array.error();
    BitVolume volume(array->size);
    static_cast<void>(visit_values(*array, {}, [&](const Vec3i& voxel, double value) {
        if (value != 0) volume.set(voxel);
    }));
    return volume;
}

Result<BitVolume> read_npy(const std::filesystem::path& path, const NpyOptions& options) {
    const std::uint64_t most = options.max_voxels + kMaxHeader + 12;
    const Result<WholeFile> file = read_whole_file(path, most);
    if (file) return parse_npy(file->view(), path.string(), options);
    if (file.error().code != ErrorCode::kFileTooLarge) return file.error();
    return {ErrorCode::kVolumeTooLarge, file.error().message};
}

std::string format_npy(const BitVolume& volume) {
    const Vec3i size = volume.size();
    std::string header = "{'descr': '|u1', 'fortran_order': False, 'shape': (" +
                         std::to_string(size.x()) + ", " + std::to_string(size.y()) + ", " +
                         std::to_string(size.z()) + "), }";
    // The values start at a multiple of 64 bytes, after a newline.
    const std::size_t prefix = kMagic.size() + 4;
    header.append(63 - (prefix + header.size()) % 64, ' ');
    header.push_back('\n');
    std::string bytes(kMagic);
    bytes += {'\x01', '\x00', static_cast<char>(header.size() & 0xff),
              static_cast<char>(header.size() >> 8)};
    bytes += header;
    const std::size_t start = bytes.size();
    bytes.resize(start + volume.voxel_count(), '\0');
    const auto ny = static_cast<std::size_t>(size.y());
    const auto nz = static_cast<std::size_t>(size.z());
    for_each_voxel(volume, [&](const Vec3i& v) {
        bytes[start +
              (static_cast<std::size_t>(v.x()) * ny + static_cast<std::size_t>(v.y())) * nz +
              static_cast<std::size_t>(v.z())] = 1;
    });
    return bytes;
}

Result<void> write_npy(const BitVolume& volume, const std::filesystem::path& path) {
    return write_whole_file(path, format_npy(volume));
}

}  // namespace ossuary::voxel
