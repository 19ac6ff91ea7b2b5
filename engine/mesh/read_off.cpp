#include "engine/mesh/read_off.h"

#include <algorithm>
#include <optional>
#include <string>

#include "engine/core/named.h"
#include "engine/mesh/line_numbers.h"
#include "engine/mesh/mesh_builder.h"
#include "engine/mesh/off_header.h"
#include "engine/mesh/read_off_binary.h"
#include "engine/mesh/text_scanner.h"

namespace ossuary::mesh {
namespace {

constexpr std::size_t kShortestVertex = 6;  // "0 0 0\n"
constexpr std::size_t kShortestFace = 8;    // "3 0 1 2\n"
constexpr std::uint64_t kVerticesBetweenLooks = 4096;

constexpr ReaderCodes kOffCodes = {ErrorCode::kOffTooManyVertices, ErrorCode::kOffTooManyFaces,
                                   ErrorCode::kOffTooManyCorners, ErrorCode::kOffBadNumber,
                                   ErrorCode::kOffNonFinite};

/// Reads what follows the header, one vertex and one face a line.
class OffBodyReader {
public:
    OffBodyReader(const TextScanner& scanner, const OffHeader& header, MeshBuilder builder)
        : scanner_(scanner), header_(header), builder_(std::move(builder)) {
        builder_.reserve(
            std::min<std::size_t>(header.vertices, scanner.bytes_left() / kShortestVertex + 1),
            std::min<std::size_t>(header.faces, scanner.bytes_left() / kShortestFace + 1));
    }

    /// Element by element, each on its own line.
    Result<void> read_lines() {
        for (std::uint64_t i = 0; i < header_.vertices; ++i) {
            if (Result<void> read = read_vertex_line(i); !read) return read;
        }
        for (std::uint64_t i = 0; i < header_.faces; ++i) {
            if (Result<void> read = read_face_line(i); !read) return read;
        }
        note_trailing_text();
        return {};
    }

    /// As a sequence of numbers whose lines mean nothing; `skipped` numbers follow each position.
    /// Colours of faces cannot be told from faces then, so all must come out even.
    Result<void> read_free_form(int skipped) {
        for (std::uint64_t i = 0; i < header_.vertices; ++i) {
            if (Result<void> read = read_position(i, true); !read) return read;
            for (int value = 0; value < skipped; ++value) {
                if (!scanner_.find_token()) return ends_early("vertex", i, header_.vertices);
                scanner_.advance(scanner_.peek_token().size());
            }
        }
        for (std::uint64_t i = 0; i < header_.faces; ++i) {
            if (Result<void> read = read_corners(i, true); !read) return read;
            if (corners_.empty()) return fail(ErrorCode::kOffBadNumber, "expected a face");
            if (Result<void> added = add_face(); !added) return added;
        }
        if (scanner_.find_token()) return fail(ErrorCode::kOffTruncated, "expected the end");
        return {};
    }

    /// One vertex a line, but faces that may go on in the next lines; what follows their last
    /// corner on its line is a colour. Colours of vertices or faces that end early could be taken
    /// for one another, so all must come out even.
    Result<void> read_wrapped_faces() {
        for (std::uint64_t i = 0; i < header_.vertices; ++i) {
            if (Result<void> read = read_vertex_line(i); !read) return read;
        }
        for (std::uint64_t i = 0; i < header_.faces; ++i) {
            if (Result<void> read = read_corners(i, true); !read) return read;
            if (!scanner_.at_line_end()) read_face_colour(i);
            if (Result<void> added = add_face(); !added) return added;
        }
        if (scanner_.find_token()) return fail(ErrorCode::kOffTruncated, "expected the end");
        return {};
    }

    ReadMeshResult take(bool free_form);

private:
    [[nodiscard]] Error fail(ErrorCode code, const std::string& text) const {
        return at_line(scanner_.line(), {code, text});
    }
    [[nodiscard]] Error ends_early(const std::string& noun, std::uint64_t done,
                                   std::uint64_t expected) const {
        return fail(ErrorCode::kOffTruncated, "expected " + plural(expected, noun) +
                                                  ", the file ends after " + std::to_string(done));
    }
    [[nodiscard]] Error bad_corner(std::uint64_t face, std::size_t corner, NumberStatus status,
                                   std::uint64_t index) const;

    Result<void> read_position(std::uint64_t vertex, bool over_lines);
    Result<void> read_vertex_line(std::uint64_t vertex);
    Result<void> read_corners(std::uint64_t face, bool over_lines);
    Result<void> read_face_line(std::uint64_t face);
    Result<void> add_face();
    // Cold: as a part of their callers they cost files without colours a twentieth of the time.
    [[gnu::cold]] void read_vertex_colour(std::uint64_t vertex);
    [[gnu::cold]] void read_face_colour(std::uint64_t face);
    void note_trailing_text();

    TextScanner scanner_;
    const OffHeader& header_;
    MeshBuilder builder_;
    std::vector<std::uint32_t> corners_;
    NumberColours vertex_colours_;
    NumberColours face_colours_;
    std::size_t extended_vertices_ = 0;
    std::size_t trailing_lines_ = 0;
    std::size_t first_trailing_line_ = 0;
};

Result<void> OffBodyReader::read_position(std::uint64_t vertex, bool over_lines) {
    if (vertex % kVerticesBetweenLooks == 0 && builder_.cancelled()) {
        return MeshBuilder::cancellation();
    }
    Vec3 position;
    double w = 1;
    const int coordinates = header_.has_w ? 4 : 3;
    for (int axis = 0; axis < coordinates; ++axis) {
        if (over_lines ? !scanner_.find_token() : scanner_.at_line_end()) {
            return fail(ErrorCode::kOffTruncated, "vertex " + std::to_string(vertex) +
                                                      ": expected " + std::to_string(coordinates) +
                                                      " coordinates, found " +
                                                      std::to_string(axis));
        }
        double& value = axis < 3 ? position[axis] : w;
        Result<void> read = builder_.read_coordinate(scanner_, vertex, axis, value);
        if (!read) return at_line(scanner_.line(), read.error());
    }
    if (header_.has_w) {
        position /= w;
        if (!builder_.is_in_range(position)) {
            return at_line(scanner_.line(), builder_.position_error(vertex, position));
        }
    }
    builder_.add_vertex(position);
    return {};
}

Result<void> OffBodyReader::read_vertex_line(std::uint64_t vertex) {
    if (!scanner_.find_token()) return ends_early("vertex line", vertex, header_.vertices);
    if (Result<void> read = read_position(vertex, false); !read) return read;
    if (!scanner_.at_line_end()) {
        ++extended_vertices_;
        if (header_.has_colors) {
            read_vertex_colour(vertex);
        } else {
            scanner_.skip_rest_of_line();
        }
    }
    return {};
}

/// Normals come before it, texture coordinates after it.
void OffBodyReader::read_vertex_colour(std::uint64_t vertex) {
    const std::size_t before = header_.has_normals ? 3 : 0;
    const std::size_t after = header_.has_texture_coordinates ? 2 : 0;
    const LineNumbers numbers = read_line_numbers(scanner_);
    if (numbers.count == before + 3 + after || numbers.count == before + 4 + after) {
        vertex_colours_.set(vertex, numbers.three_from(before));
    }
}

/// Three or four numbers are a colour, one is a place in a map that is not in the file.
void OffBodyReader::read_face_colour(std::uint64_t face) {
    const LineNumbers numbers = read_line_numbers(scanner_);
    if (numbers.count == 3 || numbers.count == 4) face_colours_.set(face, numbers.three_from(0));
}

Error OffBodyReader::bad_corner(std::uint64_t face, std::size_t corner, NumberStatus status,
                                std::uint64_t index) const {
    const std::string where =
        "corner " + std::to_string(corner) + " of face " + std::to_string(face);
    if (status == NumberStatus::kNotANumber) {
        return fail(ErrorCode::kOffBadNumber, where + ": expected a vertex index, found " +
                                                  quoted_token(scanner_.peek_token()));
    }
    const std::string found =
        status == NumberStatus::kOk ? std::to_string(index) : quoted_token(scanner_.peek_token());
    const std::string range = header_.vertices == 0
                                  ? "no index, as there are no vertices"
                                  : "an index from 0 to " + std::to_string(header_.vertices - 1);
    return fail(ErrorCode::kOffIndexOutOfRange, where + ": expected " + range + ", found " + found);
}

/// Reads the corners of a face into `corners_`.
Result<void> OffBodyReader::read_corners(std::uint64_t face, bool over_lines) {
    if (!scanner_.find_token()) return ends_early("face line", face, header_.faces);
    std::uint64_t count = 0;
    const NumberStatus status = scanner_.read_count(count);
    if (status == NumberStatus::kTooLarge) {
        return at_line(scanner_.line(),
                       builder_.too_many_corners(quoted_token(scanner_.peek_token())));
    }
    if (status != NumberStatus::kOk) {
        return fail(ErrorCode::kOffBadNumber, "face " + std::to_string(face) +
                                                  ": expected its number of corners, found " +
                                                  quoted_token(scanner_.peek_token()));
    }
    if (Result<void> caps = builder_.check_corners(count); !caps) {
        return at_line(scanner_.line(), caps.error());
    }
    corners_.clear();
    for (std::uint64_t corner = 0; corner < count; ++corner) {
        if (over_lines ? !scanner_.find_token() : scanner_.at_line_end()) {
            return fail(ErrorCode::kOffTruncated, "face " + std::to_string(face) + ": expected " +
                                                      plural(count, "corner") + ", found " +
                                                      std::to_string(corner));
        }
        std::uint64_t index = 0;
        const NumberStatus read = scanner_.read_count(index);
        if (read != NumberStatus::kOk || index >= header_.vertices) {
            return bad_corner(face, corner, read, index);
        }
        corners_.push_back(static_cast<std::uint32_t>(index));
    }
    return {};
}

Result<void> OffBodyReader::read_face_line(std::uint64_t face) {
    if (Result<void> read = read_corners(face, false); !read) return read;
    if (!scanner_.at_line_end()) read_face_colour(face);
    return add_face();
}

Result<void> OffBodyReader::add_face() {
    const Result<void> added = builder_.add_face(corners_);
    return added ? added : at_line(scanner_.line(), added.error());
}

void OffBodyReader::note_trailing_text() {
    while (scanner_.find_token()) {
        if (trailing_lines_ == 0) first_trailing_line_ = scanner_.line();
        ++trailing_lines_;
        scanner_.skip_rest_of_line();
    }
}

ReadMeshResult OffBodyReader::take(bool free_form) {
    const bool announced =
        header_.has_normals || header_.has_colors || header_.has_texture_coordinates;
    builder_.warn("header_missing", header_.has_word ? 0 : 1,
                  "the file starts without the word OFF");
    builder_.warn("edge_count_missing", header_.has_edge_count ? 0 : 1,
                  "the number of edges is missing");
    builder_.warn("free_form_lines", free_form ? 1 : 0,
                  "the file does not keep to one vertex or face a line");
    builder_.warn("unannounced_vertex_values", announced ? 0 : extended_vertices_,
                  plural(extended_vertices_, "vertex line") + " with more than three coordinates");
    builder_.warn("trailing_text", trailing_lines_,
                  plural(trailing_lines_, "line") + " after the last face, from line " +
                      std::to_string(first_trailing_line_));
    builder_.set_vertex_colours(vertex_colours_.take(builder_.vertices().size()));
    builder_.set_face_colours(face_colours_.take(builder_.face_count()));
    return builder_.take();
}

/// Reads the text as a free sequence of numbers, or as lines of which faces take more than one, if
/// that comes out even.
std::optional<ReadMeshResult> try_free_form(const TextScanner& scanner, const OffHeader& header,
                                            const MeshBuilder& builder) {
    const int other_values =
        (header.has_normals ? 3 : 0) + (header.has_texture_coordinates ? 2 : 0);
    for (const int color_values : {4, 3}) {
        OffBodyReader reader(scanner, header, builder);
        if (reader.read_free_form(other_values + (header.has_colors ? color_values : 0))) {
            return reader.take(true);
        }
        if (!header.has_colors) break;
    }
    OffBodyReader reader(scanner, header, builder);
    if (reader.read_wrapped_faces()) return reader.take(true);
    return std::nullopt;
}

Result<ReadMeshResult> read_off_text(std::string_view file, const MeshBuilder& builder) {
    TextScanner start(file);
    if (const auto header = read_off_header(start); header && header->is_binary) {
        auto read =
            read_off_binary(file.substr(file.size() - start.bytes_left()), *header, builder);
        return read ? read : at_line(start.line() - 1, read.error());
    }
    const std::string_view text = without_closing_braces(file);
    if (std::optional<Error> binary = nul_byte(text, ErrorCode::kOffBinary)) return *binary;
    TextScanner scanner(text);
    const Result<OffHeader> header = read_off_header(scanner);
    if (!header) return header.error();
    if (Result<void> caps = builder.check_counts(header->vertices, header->faces); !caps) {
        return at_line(header->counts_line, caps.error());
    }
    OffBodyReader reader(scanner, *header, builder);
    const Result<void> read = reader.read_lines();
    if (read) return reader.take(false);
    // A line that ends early, or too few lines, is also what free-form text looks like.
    if (read.error().code == ErrorCode::kOffTruncated) {
        if (auto free_form = try_free_form(scanner, *header, builder)) return *std::move(free_form);
    }
    return read.error();
}

}  // namespace

Result<ReadMeshResult> read_off(std::string_view text, std::string_view name,
                                const ReadMeshOptions& options, const std::stop_token& stop) {
    return named(name, read_off_text(text, MeshBuilder(kOffCodes, options, stop)));
}

}  // namespace ossuary::mesh
