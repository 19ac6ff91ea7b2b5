#include "engine/mesh/read_xyz.h"

#include <array>
#include <optional>
#include <string>

#include "engine/core/named.h"
#include "engine/mesh/mesh_builder.h"
#include "engine/mesh/text_scanner.h"

namespace ossuary::mesh {
namespace {

constexpr ReaderCodes kXyzCodes = {ErrorCode::kXyzTooManyPoints, ErrorCode::kXyzTooManyPoints,
                                   ErrorCode::kXyzTooManyPoints, ErrorCode::kXyzBadNumber,
                                   ErrorCode::kXyzNonFinite};

/// Moves to the next line that holds more than a comment; false at the end of the text.
bool find_line(TextScanner& scanner) {
    while (scanner.find_token()) {
        if (!scanner.peek_token().starts_with("//")) return true;
        scanner.skip_rest_of_line();
    }
    return false;
}

/// The number of points, where the scanner is at a line that holds one count and nothing else,
/// which it moves over.
std::optional<std::uint64_t> take_count(TextScanner& scanner) {
    TextScanner ahead = scanner;
    std::uint64_t count = 0;
    if (ahead.read_count(count) != NumberStatus::kOk || !ahead.at_line_end()) return std::nullopt;
    scanner = ahead;
    return count;
}

/// Moves to the end of the line; whether three numbers are all that it holds.
bool is_bare_point(TextScanner& scanner) {
    bool bare = true;
    for (int axis = 0; axis < 3 && bare; ++axis) {
        double ignored = 0;
        bare = !scanner.at_line_end() && scanner.read_double(ignored) == NumberStatus::kOk;
    }
    bare = bare && scanner.at_line_end();
    scanner.skip_rest_of_line();
    return bare;
}

Result<ReadMeshResult> read_points(std::string_view text, MeshBuilder builder) {
    constexpr std::uint64_t kPointsBetweenLooks = 4096;
    TextScanner scanner(text);
    scanner.skip_byte_order_mark();
    std::optional<std::uint64_t> announced;
    if (find_line(scanner)) announced = take_count(scanner);
    std::uint64_t points = 0;
    for (; find_line(scanner); ++points) {
        if (points % kPointsBetweenLooks == 0 && builder.cancelled()) {
            return MeshBuilder::cancellation();
        }
        if (Result<void> caps = builder.check_counts(points + 1, 0); !caps) {
            return at_line(scanner.line(), caps.error());
        }
        Vec3 position;
        for (int axis = 0; axis < 3; ++axis) {
            if (scanner.at_line_end()) {
                return at_line(scanner.line(),
                               {ErrorCode::kXyzTruncated, "point " + std::to_string(points) +
                                                              ": expected 3 coordinates, found " +
                                                              std::to_string(axis)});
            }
            Result<void> read = builder.read_coordinate(scanner, points, axis, position[axis]);
            if (!read) return at_line(scanner.line(), read.error());
        }
        builder.add_vertex(position);
        scanner.skip_rest_of_line();
    }
    if (announced && *announced != points) {
        builder.warn(
            "point_count_differs", 1,
            std::to_string(*announced) + " points announced, found " + std::to_string(points));
    }
    return builder.take();
}

}  // namespace

bool looks_like_xyz(std::string_view text) {
    constexpr std::size_t kGlance = 1 << 16;
    constexpr std::size_t kLines = 32;
    const bool whole = text.size() <= kGlance;
    TextScanner scanner(text.substr(0, kGlance));
    scanner.skip_byte_order_mark();
    if (!find_line(scanner)) return false;
    take_count(scanner);
    std::size_t lines = 0;
    for (; lines < kLines && find_line(scanner); ++lines) {
        for (int axis = 0; axis < 3; ++axis) {
            double ignored = 0;
            if (!scanner.at_line_end() && scanner.read_double(ignored) == NumberStatus::kOk) {
                continue;
            }
            // The glance may end within a line.
            return lines > 0 && !whole && scanner.bytes_left() < 64;
        }
        scanner.skip_rest_of_line();
    }
    return lines > 0;
}

bool is_xyz_rather_than_off(std::string_view text) {
    constexpr std::size_t kGlance = 1 << 20;
    constexpr std::uint64_t kFewest = 32;
    const bool whole = text.size() <= kGlance;
    TextScanner scanner(text.substr(0, kGlance));
    scanner.skip_byte_order_mark();
    if (!find_line(scanner)) return false;
    std::array<std::uint64_t, 3> counts{};
    for (std::uint64_t& count : counts) {
        if (scanner.at_line_end() || scanner.read_count(count) != NumberStatus::kOk) return false;
    }
    if (!scanner.at_line_end()) return false;
    std::uint64_t others = 0;
    for (; find_line(scanner); ++others) {
        if (!is_bare_point(scanner)) {
            if (!whole && scanner.bytes_left() == 0) break;  // cut by the glance
            return false;
        }
    }
    const std::uint64_t vertices = counts[0], faces = counts[1];
    if (vertices == 0 && faces == 0) return others > 0;
    if (others + 1 < kFewest || others == vertices + faces) return false;
    return whole || others > vertices;
}

Result<ReadMeshResult> read_xyz(std::string_view text, std::string_view name,
                                const ReadMeshOptions& options, const std::stop_token& stop) {
    return named(name, read_points(text, MeshBuilder(kXyzCodes, options, stop)));
}

}  // namespace ossuary::mesh
