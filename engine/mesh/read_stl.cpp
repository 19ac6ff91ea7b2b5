#include "engine/mesh/read_stl.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "engine/core/named.h"
#include "engine/mesh/load_number.h"
#include "engine/mesh/mesh_builder.h"
#include "engine/mesh/model_objects.h"
#include "engine/mesh/stl_colours.h"
#include "engine/mesh/vertex_table.h"

namespace ossuary::mesh {
namespace {

constexpr std::size_t kStlNormal = 12;

constexpr ReaderCodes kStlCodes = {ErrorCode::kStlTooManyVertices, ErrorCode::kStlTooManyFaces,
                                   ErrorCode::kStlTooManyCorners, ErrorCode::kStlBadNumber,
                                   ErrorCode::kStlNonFinite};

std::uint64_t announced_triangles(std::string_view bytes) {
    return load_number<std::uint32_t>(bytes.data() + kStlHeader, std::endian::little);
}

using StlCorners = std::array<float, 9>;

StlCorners load_corners(std::string_view bytes, std::size_t triangle) {
    const char* const start = bytes.data() + kStlStart + kStlTriangle * triangle + kStlNormal;
    StlCorners corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        corners[i] = load_number<float>(start + i * sizeof(float), std::endian::little);
    }
    return corners;
}

/// Triangles whose corners are announced to the table before they are looked up there: 47 ms become
/// 30 for 500,000 triangles.
constexpr std::size_t kStlBlock = 16;

/// Adds the triangles from `begin` to `end`, no more than a block.
/// @param attributes  gets the bits of theirs, too
Result<void> read_block(std::string_view bytes, std::size_t begin, std::size_t end,
                        VertexTable& table, MeshBuilder& builder, std::uint32_t& attributes) {
    std::array<Vec3, 3 * kStlBlock> positions;
    std::array<std::uint64_t, 3 * kStlBlock> hashes{};
    const std::size_t count = 3 * (end - begin);
    std::uint32_t seen = 0;
    for (std::size_t t = begin; t < end; ++t) {
        const StlCorners corners = load_corners(bytes, t);
        seen |= stl_attribute(bytes, t);
        for (std::size_t corner = 0; corner < 3; ++corner) {
            positions[3 * (t - begin) + corner] = {corners[3 * corner], corners[3 * corner + 1],
                                                   corners[3 * corner + 2]};
        }
    }
    attributes |= seen;
    for (std::size_t i = 0; i < count; ++i) {
        if (!builder.is_in_range(positions[i])) {
            const Error error = builder.position_error(3 * begin + i, positions[i]);
            return {error.code, "triangle " + std::to_string(begin + i / 3) + ": " + error.message};
        }
        hashes[i] = table.announce(positions[i]);
    }
    for (std::size_t i = 0; i < count; i += 3) {
        TriangleMesh::Triangle triangle{};
        for (std::size_t corner = 0; corner < 3; ++corner) {
            triangle[corner] = table.number_of(positions[i + corner], hashes[i + corner]);
        }
        if (Result<void> added = builder.add_face(triangle); !added) return added;
    }
    return {};
}

Result<ReadMeshResult> read_binary(std::string_view bytes, const ReadMeshOptions& options,
                                   const std::stop_token& stop) {
    MeshBuilder builder(kStlCodes, options, stop);
    const std::uint64_t triangles = announced_triangles(bytes);
    if (Result<void> caps = builder.check_counts(0, triangles); !caps) return caps.error();
    const std::uint64_t whole = (bytes.size() - kStlStart) / kStlTriangle;
    if (whole < triangles) {
        return {ErrorCode::kStlTruncated, "expected " + plural(triangles, "triangle") +
                                              ", the file ends after " + std::to_string(whole)};
    }
    builder.reserve(0, triangles);
    VertexTable table(triangles / 2);  // of a closed surface; grows for others
    std::uint32_t attributes = 0;
    for (std::uint64_t t = 0; t < triangles; t += kStlBlock) {
        const std::uint64_t end = std::min<std::uint64_t>(t + kStlBlock, triangles);
        if (Result<void> read = read_block(bytes, t, end, table, builder, attributes); !read) {
            return read.error();
        }
    }
    if (Result<void> caps = builder.check_counts(table.vertices().size(), 0); !caps) {
        return caps.error();
    }
    builder.set_vertices(std::move(table).take());
    const std::size_t trailing = bytes.size() - kStlStart - kStlTriangle * triangles;
    builder.warn("trailing_bytes", trailing, plural(trailing, "byte") + " after the last triangle");
    builder.set_face_colours(stl_colours(bytes, triangles, attributes));
    return builder.take();
}

class StlTextReader {
public:
    StlTextReader(std::string_view text, const ReadMeshOptions& options,
                  const std::stop_token& stop)
        : scanner_(text), builder_(kStlCodes, options, stop) {}

    Result<ReadMeshResult> read();

private:
    [[nodiscard]] Error fail(ErrorCode code, const std::string& text) const {
        return at_line(scanner_.line(), {code, text});
    }
    [[nodiscard]] bool at(std::string_view capitals) const {
        return spells(scanner_.peek_token(), capitals);
    }
    [[nodiscard]] Error unexpected(std::string_view expected) const {
        return fail(ErrorCode::kStlSyntax, "expected " + std::string(expected) + ", found " +
                                               quoted_token(scanner_.peek_token()));
    }
    Result<void> expect(std::string_view capitals, std::string_view word);
    std::string read_name();
    Result<void> read_line();
    Result<void> read_facet();
    Result<void> read_vertices();

    TextScanner scanner_;
    MeshBuilder builder_;
    VertexTable table_;
    std::vector<std::uint32_t> corners_;
    std::vector<std::uint32_t> faces_;         // corners of all, one after the other
    std::vector<std::uint32_t> face_corners_;  // how many each has
    std::vector<ObjectMark> solids_;
    std::uint64_t positions_ = 0;
    bool open_ = false;   // within a solid
    bool begun_ = false;  // a solid or a facet has been seen
    std::size_t trailing_lines_ = 0;
    std::size_t first_trailing_line_ = 0;
};

/// Moves over a word, which may stand on a later line.
Result<void> StlTextReader::expect(std::string_view capitals, std::string_view word) {
    if (!scanner_.find_token()) {
        return fail(ErrorCode::kStlTruncated,
                    "expected " + std::string(word) + ", found the end of the file");
    }
    if (!at(capitals)) return unexpected(word);
    scanner_.advance(capitals.size());
    return {};
}

/// A name lasts to the end of the line, but for files that are one line.
std::string StlTextReader::read_name() {
    std::string name;
    while (!scanner_.at_line_end()) {
        const std::string_view word = scanner_.peek_token();
        if (at("FACET")) {
            TextScanner ahead = scanner_;
            ahead.advance(word.size());
            if (!ahead.at_line_end() && spells(ahead.peek_token(), "NORMAL")) break;
        }
        if (!name.empty()) name += ' ';
        name += word;
        scanner_.advance(word.size());
    }
    return name;
}

Result<void> StlTextReader::read_vertices() {
    corners_.clear();
    while (true) {
        if (!scanner_.find_token()) break;
        if (!at("VERTEX")) break;
        scanner_.advance(scanner_.peek_token().size());
        if (Result<void> caps = builder_.check_corners(corners_.size() + 1); !caps) {
            return at_line(scanner_.line(), caps.error());
        }
        Vec3 position;
        for (int axis = 0; axis < 3; ++axis) {
            if (!scanner_.find_token()) {
                return fail(ErrorCode::kStlTruncated, "vertex " + std::to_string(positions_) +
                                                          ": expected 3 coordinates, found " +
                                                          std::to_string(axis));
            }
            Result<void> read =
                builder_.read_coordinate(scanner_, positions_, axis, position[axis]);
            if (!read) return at_line(scanner_.line(), read.error());
        }
        ++positions_;
        corners_.push_back(table_.number_of(position));
    }
    return {};
}

/// Reads what follows the word `facet`.
Result<void> StlTextReader::read_facet() {
    constexpr int kWordsOfNormal = 4;
    for (int word = 0; word < kWordsOfNormal && scanner_.find_token() && !at("OUTER"); ++word) {
        if (word == 0 && !at("NORMAL")) return unexpected("normal or outer loop");
        scanner_.advance(scanner_.peek_token().size());
    }
    do {
        if (Result<void> word = expect("OUTER", "outer loop"); !word) return word;
        if (Result<void> word = expect("LOOP", "loop"); !word) return word;
        if (Result<void> read = read_vertices(); !read) return read;
        if (Result<void> word = expect("ENDLOOP", "vertex or endloop"); !word) return word;
        faces_.insert(faces_.end(), corners_.begin(), corners_.end());
        face_corners_.push_back(static_cast<std::uint32_t>(corners_.size()));
    } while (scanner_.find_token() && at("OUTER"));
    return expect("ENDFACET", "endfacet");
}

Result<void> StlTextReader::read_line() {
    const std::string_view token = scanner_.peek_token();
    if (spells(token, "SOLID") || spells(token, "ENDSOLID")) {
        open_ = token.size() == std::string_view("SOLID").size();
        begun_ = true;
        scanner_.advance(token.size());
        std::string name = read_name();
        if (open_) {
            solids_.push_back({std::move(name), static_cast<std::uint32_t>(face_corners_.size())});
        }
    } else if (spells(token, "FACET")) {
        open_ = true;
        begun_ = true;
        scanner_.advance(token.size());
        return read_facet();
    } else if (spells(token, "COLOR")) {
        scanner_.skip_rest_of_line();
    } else if (open_ || !begun_) {
        return unexpected(open_ ? "facet or endsolid" : "solid");
    } else {
        if (trailing_lines_++ == 0) first_trailing_line_ = scanner_.line();
        scanner_.skip_rest_of_line();
    }
    return {};
}

Result<ReadMeshResult> StlTextReader::read() {
    scanner_.skip_byte_order_mark();
    for (std::size_t lines = 0; scanner_.find_token(); ++lines) {
        if (lines % 1024 == 0 && builder_.cancelled()) return MeshBuilder::cancellation();
        if (Result<void> read = read_line(); !read) return read.error();
        Result<void> caps = builder_.check_counts(table_.vertices().size(), face_corners_.size());
        if (!caps) return at_line(scanner_.line(), caps.error());
    }
    builder_.reserve(0, face_corners_.size());
    builder_.set_vertices(std::move(table_).take());
    std::span<const std::uint32_t> rest = faces_;
    for (const std::uint32_t corners : face_corners_) {
        if (Result<void> added = builder_.add_face(rest.first(corners)); !added) {
            return added.error();
        }
        rest = rest.subspan(corners);
    }
    if (!begun_) return fail(ErrorCode::kStlSyntax, "expected solid, found the end of the file");
    builder_.warn("end_missing", open_ ? 1 : 0, "the file ends without endsolid");
    builder_.warn("trailing_text", trailing_lines_,
                  plural(trailing_lines_, "line") + " outside any solid, from line " +
                      std::to_string(first_trailing_line_));
    ReadMeshResult read = builder_.take();
    read.objects = objects_between(solids_, read.mesh);
    return read;
}

}  // namespace

bool is_binary_stl(std::string_view bytes) {
    return bytes.size() >= kStlStart &&
           bytes.size() == kStlStart + kStlTriangle * announced_triangles(bytes);
}

bool resembles_binary_stl(std::string_view bytes) {
    constexpr std::size_t kTrianglesLookedAt = 8;
    constexpr float kSmallest = 1e-30F;
    constexpr float kLargest = 1e30F;
    if (bytes.size() < kStlStart + kStlTriangle) return false;
    // Text holds no zero byte; a count of triangles that a file can have does.
    if (bytes.substr(kStlHeader, 4).find('\0') == std::string_view::npos) return false;
    const std::uint64_t triangles = announced_triangles(bytes);
    const std::uint64_t whole = (bytes.size() - kStlStart) / kStlTriangle;
    const std::uint64_t looked_at = std::min({triangles, whole, std::uint64_t{kTrianglesLookedAt}});
    for (std::uint64_t t = 0; t < looked_at; ++t) {
        for (const float x : load_corners(bytes, t)) {
            if (x != 0 && !(std::abs(x) > kSmallest && std::abs(x) < kLargest)) return false;
        }
    }
    return triangles > 0;
}

bool looks_like_stl_text(std::string_view text) {
    constexpr std::size_t kGlance = 4096;
    TextScanner scanner(text.substr(0, kGlance));
    scanner.skip_byte_order_mark();
    if (!scanner.find_token()) return false;
    if (spells(scanner.peek_token(), "FACET")) {
        scanner.advance(scanner.peek_token().size());
        return scanner.find_token() && spells(scanner.peek_token(), "NORMAL");
    }
    if (!spells(scanner.peek_token(), "SOLID")) return false;
    scanner.advance(scanner.peek_token().size());
    while (scanner.find_token()) {
        const std::string_view token = scanner.peek_token();
        if (spells(token, "FACET") || spells(token, "ENDSOLID")) return true;
        scanner.advance(token.size());
    }
    return false;
}

Result<ReadMeshResult> read_stl(std::string_view bytes, std::string_view name,
                                const ReadMeshOptions& options, const std::stop_token& stop) {
    const bool binary = is_binary_stl(bytes) || resembles_binary_stl(bytes);
    return named(name, binary ? read_binary(bytes, options, stop)
                              : StlTextReader(bytes, options, stop).read());
}

}  // namespace ossuary::mesh
