#include <algorithm>
#include <array>
#include <cstring>
#include <string>

#include "engine/core/named.h"
#include "engine/mesh/text_scanner.h"
#include "engine/voxel/volume.h"
#include "engine/voxel/volume_parts.h"

namespace ossuary::voxel {
namespace {

struct BinvoxHeader {
    std::array<std::uint64_t, 3> sides{};
    Vec3 translate = Vec3::Zero();
    double scale = 1.0;
    std::size_t bytes = 0;  ///< up to the runs
};

Error invalid_binvox(const std::string& where, const std::string& what) {
    return {ErrorCode::kBinvoxInvalid, where + ": " + what};
}

Result<double> read_real(mesh::TextScanner& scanner) {
    double value = 0;
    if (!scanner.at_line_end() && scanner.read_double(value) == mesh::NumberStatus::kOk) {
        return value;
    }
    return invalid_binvox(
        "", "expected a number, found " + mesh::quoted_token(scanner.peek_token().substr(0, 40)));
}

/// One line of the header after its first.
Result<void> read_header_line(std::string_view line, BinvoxHeader& header) {
    mesh::TextScanner scanner(line);
    if (scanner.at_line_end()) return {};
    const std::string_view word = scanner.peek_token();
    scanner.advance(word.size());
    if (word == "dim") {
        for (std::uint64_t& side : header.sides) {
            if (scanner.at_line_end() || scanner.read_count(side) != mesh::NumberStatus::kOk ||
                side == 0) {
                return invalid_binvox("", "expected three sides of at least 1 after dim");
            }
        }
    } else if (word == "translate") {
        for (int axis = 0; axis < 3; ++axis) {
            const Result<double> value = read_real(scanner);
            if (!value) return value.error();
            header.translate[axis] = *value;
        }
    } else if (word == "scale") {
        const Result<double> value = read_real(scanner);
        if (!value) return value.error();
        header.scale = *value;
    } else {
        return invalid_binvox(
            "", "expected dim, translate, scale or data, found " + mesh::quoted_token(word));
    }
    return {};
}

Result<BinvoxHeader> read_header(std::string_view bytes) {
    constexpr std::size_t kLongestHeader = 4096;
    BinvoxHeader header;
    std::size_t at = 0;
    for (std::size_t number = 1; at < std::min(bytes.size(), kLongestHeader); ++number) {
        const std::size_t end = bytes.find('\n', at);
        if (end == std::string_view::npos) break;
        std::string_view line = bytes.substr(at, end - at);
        if (line.ends_with('\r')) line.remove_suffix(1);
        at = end + 1;
        const std::string where = "line " + std::to_string(number);
        if (number == 1) {
            if (line == "#binvox 1") continue;
            return invalid_binvox(where, "expected #binvox 1, found " + mesh::quoted_token(line));
        }
        if (line == "data") {
            header.bytes = at;
            if (header.sides[0] > 0) return header;
            return invalid_binvox(where, "expected dim before data");
        }
        if (Result<void> read = read_header_line(line, header); !read) {
            return invalid_binvox(where, read.error().message.substr(2));
        }
    }
    return invalid_binvox("line 1", "expected a header that ends with data, found no such line");
}

/// The values that the runs stand for; each run is a value and its length.
Result<WholeFile> unroll(std::string_view runs, std::size_t start, std::uint64_t voxels,
                         const std::stop_token& stop) {
    constexpr std::size_t kLongestRun = 255;
    constexpr std::size_t kRunsBetweenLooks = 65'536;
    const auto ends_early = [&](std::uint64_t found) {
        return invalid_binvox("byte " + std::to_string(start + runs.size()),
                              "expected runs of " + std::to_string(voxels) +
                                  " voxels, the file ends after " + std::to_string(found));
    };
    // Nothing is made room for that cannot be there.
    if (runs.size() / 2 * kLongestRun < voxels) return ends_early(runs.size() / 2 * kLongestRun);
    WholeFile values(voxels);
    std::uint64_t at = 0;
    for (std::size_t run = 0; at < voxels; ++run) {
        if (2 * run + 1 >= runs.size()) return ends_early(at);
        if (run % kRunsBetweenLooks == 0 && stop.stop_requested()) {
            return Error{ErrorCode::kCancelled, "reading was cancelled"};
        }
        const auto length = static_cast<unsigned char>(runs[2 * run + 1]);
        if (length > voxels - at) {
            return invalid_binvox("byte " + std::to_string(start + 2 * run),
                                  "expected a run of at most " + std::to_string(voxels - at) +
                                      " voxels, found " + std::to_string(length));
        }
        std::memset(values.data() + at, runs[2 * run] == 0 ? 0 : 1, length);
        at += length;
    }
    return values;
}

Result<Volume> read_binvox_bytes(std::string_view bytes, const VolumeOptions& options,
                                 const std::stop_token& stop) {
    const Result<BinvoxHeader> header = read_header(bytes);
    if (!header) return header.error();
    const Result<Vec3i> stored = checked_size(header->sides, options);
    if (!stored) return stored.error();
    Volume volume;
    // y runs fastest, then z, then x: dim names them slowest first.
    volume.size = Vec3i(stored->z(), stored->y(), stored->x());
    const double side = header->scale / stored->maxCoeff();
    volume.axes << 0, 0, side, side, 0, 0, 0, side, 0;
    volume.origin = header->translate + Vec3::Constant(side / 2);
    if (!is_usable_frame(volume.origin, volume.axes) || header->scale < 0) {
        return invalid_binvox("header", "expected a scale above 0 and a finite translation");
    }
    auto values = unroll(bytes.substr(header->bytes), header->bytes, volume.voxel_count(), stop);
    if (!values) return values.error();
    volume.unpacked = *std::move(values);
    volume.values = volume.unpacked.view();
    return volume;
}

}  // namespace

Result<Volume> read_binvox(std::string_view bytes, std::string_view name,
                           const VolumeOptions& options, const std::stop_token& stop) {
    return named(name, read_binvox_bytes(bytes, options, stop));
}

}  // namespace ossuary::voxel
