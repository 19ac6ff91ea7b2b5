#include <algorithm>
#include <cstring>
#include <string>
#include <utility>

#include "engine/core/named.h"
#include "engine/mesh/text_scanner.h"
#include "engine/voxel/nrrd_header.h"
#include "engine/voxel/volume.h"
#include "engine/voxel/volume_parts.h"

namespace ossuary::voxel {
namespace {

Error invalid_data(std::size_t byte, const std::string& what) {
    return {ErrorCode::kNrrdInvalid, "byte " + std::to_string(byte) + ": " + what};
}

/// What is left of the data after the lines and bytes that the header says to skip.
Result<std::string_view> skipped(std::string_view data, const NrrdHeader& header,
                                 std::uint64_t expected, bool lines) {
    for (std::uint64_t i = 0; lines && i < header.line_skip; ++i) {
        const std::size_t end = data.find('\n');
        if (end == std::string_view::npos) {
            return invalid_data(header.bytes, "expected " + std::to_string(header.line_skip) +
                                                  " lines to skip, found " + std::to_string(i));
        }
        data.remove_prefix(end + 1);
    }
    if (header.byte_skip < 0) {
        return data.substr(data.size() - std::min<std::uint64_t>(data.size(), expected));
    }
    const auto bytes = static_cast<std::uint64_t>(header.byte_skip);
    if (bytes > data.size()) {
        return invalid_data(header.bytes, "expected " + std::to_string(bytes) +
                                              " bytes to skip, found " +
                                              std::to_string(data.size()));
    }
    return data.substr(bytes);
}

Error too_short(const NrrdHeader& header, const Vec3i& size, std::uint64_t expected,
                std::size_t found) {
    return invalid_data(header.bytes, "expected " + std::to_string(expected) + " bytes for " +
                                          size_text(size) + " voxels, found " +
                                          std::to_string(found));
}

/// Numbers as words, kept as doubles of this machine's byte order.
Result<void> read_words(std::string_view data, std::size_t start, Volume& volume,
                        const std::stop_token& stop) {
    constexpr std::uint64_t kBetweenLooks = 65'536;
    const std::uint64_t voxels = volume.voxel_count();
    const auto ends_early = [&](std::uint64_t found) {
        return invalid_data(start, "expected " + std::to_string(voxels) +
                                       " numbers, the file ends after " + std::to_string(found));
    };
    if (data.size() / 2 + 1 < voxels) return ends_early(data.size() / 2 + 1);
    volume.unpacked = WholeFile(voxels * sizeof(double));
    mesh::TextScanner scanner(data);
    for (std::uint64_t i = 0; i < voxels; ++i) {
        if (i % kBetweenLooks == 0 && stop.stop_requested()) {
            return {ErrorCode::kCancelled, "reading was cancelled"};
        }
        double value = 0;
        if (!scanner.find_token()) return ends_early(i);
        if (scanner.read_double(value) != mesh::NumberStatus::kOk) {
            return invalid_data(start, "value " + std::to_string(i) +
                                           ": expected a finite number, found " +
                                           mesh::quoted_token(scanner.peek_token()));
        }
        std::memcpy(volume.unpacked.data() + i * sizeof(double), &value, sizeof(double));
    }
    volume.type = VoxelType::kFloat64;
    volume.order = std::endian::native;
    volume.values = volume.unpacked.view();
    return {};
}

Result<Volume> read_nrrd_bytes(std::string_view bytes, const VolumeOptions& options,
                               const std::stop_token& stop) {
    Result<NrrdHeader> header = read_nrrd_header(bytes);
    if (!header) return header.error();
    const Result<Vec3i> size = checked_size(header->sides, options);
    if (!size) return size.error();
    Volume volume;
    volume.size = *size;
    volume.type = header->type;
    volume.order = header->order;
    volume.origin = header->origin;
    volume.axes = header->axes;
    volume.unit = std::move(header->unit);
    const std::uint64_t expected = volume.voxel_count() * size_of(volume.type);
    std::string_view data = bytes.substr(header->bytes);
    if (header->encoding == NrrdEncoding::kText) {
        const auto text = skipped(data, *header, data.size(), true);
        if (!text) return text.error();
        if (Result<void> read = read_words(*text, header->bytes, volume, stop); !read) {
            return read.error();
        }
        return volume;
    }
    const bool packed = header->encoding == NrrdEncoding::kGzip;
    if (packed) {
        // Lines are skipped before unpacking, bytes after it.
        NrrdHeader lines_alone;
        lines_alone.line_skip = header->line_skip;
        lines_alone.bytes = header->bytes;
        const auto after_lines = skipped(data, lines_alone, 0, true);
        if (!after_lines) return after_lines.error();
        UnpackCaps caps = options.unpack;
        caps.max_bytes = std::min(
            caps.max_bytes,
            expected + static_cast<std::uint64_t>(std::max<std::int64_t>(header->byte_skip, 4096)));
        auto unpacked = gunzip(*after_lines, "data", caps, stop);
        if (!unpacked) return unpacked.error();
        volume.unpacked = *std::move(unpacked);
        data = volume.unpacked.view();
    }
    const auto values = skipped(data, *header, expected, !packed);
    if (!values) return values.error();
    if (values->size() < expected) return too_short(*header, *size, expected, values->size());
    volume.values = values->substr(0, expected);
    return volume;
}

}  // namespace

Result<Volume> read_nrrd(std::string_view bytes, std::string_view name,
                         const VolumeOptions& options, const std::stop_token& stop) {
    return named(name, read_nrrd_bytes(bytes, options, stop));
}

}  // namespace ossuary::voxel
