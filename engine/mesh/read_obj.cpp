#include "engine/mesh/read_obj.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/core/named.h"
#include "engine/mesh/line_numbers.h"
#include "engine/mesh/mesh_builder.h"
#include "engine/mesh/model_objects.h"
#include "engine/mesh/obj_lines.h"

namespace ossuary::mesh {
namespace {

constexpr ReaderCodes kObjCodes = {ErrorCode::kObjTooManyVertices, ErrorCode::kObjTooManyFaces,
                                   ErrorCode::kObjTooManyCorners, ErrorCode::kObjBadNumber,
                                   ErrorCode::kObjNonFinite};

enum class ObjStatement {
    kVertex,
    kFace,
    kObject,
    kGroup,
    kMaterial,
    kLineOrPoint,
    kFreeForm,
    kIgnored,
    kUnknown
};

ObjStatement statement_of(std::string_view word) {
    constexpr std::array<std::string_view, 5> kFreeForm = {"curv", "curv2", "surf", "bzp", "bsp"};
    constexpr std::array<std::string_view, 29> kIgnored = {
        "vn",     "vt",         "vp",        "s",    "mg",   "mtllib",   "usemap", "lod",
        "maplib", "shadow_obj", "trace_obj", "call", "csh",  "c_interp", "bevel",  "d_interp",
        "ctech",  "stech",      "cstype",    "deg",  "bmat", "step",     "parm",   "trim",
        "hole",   "scrv",       "sp",        "con",  "end"};
    const auto is_among = [&](const auto& words) {
        return std::find(words.begin(), words.end(), word) != words.end();
    };
    if (word == "v") return ObjStatement::kVertex;
    if (word == "f" || word == "fo") return ObjStatement::kFace;
    if (word == "o") return ObjStatement::kObject;
    if (word == "g") return ObjStatement::kGroup;
    if (word == "usemtl") return ObjStatement::kMaterial;
    if (word == "l" || word == "p") return ObjStatement::kLineOrPoint;
    if (is_among(kFreeForm)) return ObjStatement::kFreeForm;
    return is_among(kIgnored) ? ObjStatement::kIgnored : ObjStatement::kUnknown;
}

/// The index of a vertex as it is written, and whether what follows it is that of a corner.
struct WrittenIndex {
    bool negative = false;
    std::uint64_t magnitude = 0;  ///< all of the largest for what is beyond 64 bits
    bool well_formed = false;
};

WrittenIndex parse_corner(std::string_view token) {
    constexpr std::uint64_t kBeyond = std::numeric_limits<std::uint64_t>::max();
    WrittenIndex index;
    std::size_t at = 0;
    if (!token.empty() && (token[0] == '-' || token[0] == '+')) index.negative = token[at++] == '-';
    const std::size_t digits = at;
    for (; at < token.size() && static_cast<unsigned char>(token[at] - '0') < 10; ++at) {
        const bool fits = index.magnitude <= (kBeyond - 9) / 10;
        index.magnitude =
            fits ? index.magnitude * 10 + static_cast<std::uint64_t>(token[at] - '0') : kBeyond;
    }
    index.well_formed =
        at > digits &&
        (at == token.size() || (token[at] == '/' && token.find_first_not_of("0123456789/-+", at) ==
                                                        std::string_view::npos));
    return index;
}

class ObjReader {
public:
    ObjReader(std::string_view text, const ReadMeshOptions& options, const std::stop_token& stop)
        : lines_(text), options_(options), builder_(kObjCodes, options, stop) {
        // No counts are given; room that is not used is never touched.
        constexpr std::size_t kUsualLine = 32;
        builder_.reserve(std::min<std::size_t>(options.max_vertices, text.size() / kUsualLine),
                         std::min<std::size_t>(options.max_faces, text.size() / kUsualLine));
    }

    Result<ReadMeshResult> read();

private:
    /// Faces from the first that names a vertex to come.
    struct WaitingFace {
        std::uint32_t corners;
        std::uint32_t line;
    };

    [[nodiscard]] Error fail(ErrorCode code, const std::string& text) const {
        return at_line(lines_.number(), {code, text});
    }
    [[nodiscard]] std::uint64_t faces() const { return builder_.face_count() + waiting_.size(); }

    Result<void> read_statement();
    Result<void> read_vertex(TextScanner& scanner);
    /// Cold: as a part of its caller it costs files without colours a twentieth of the time.
    [[gnu::cold]] void read_colour(TextScanner& scanner, std::uint64_t vertex);
    Result<std::uint32_t> read_corner(std::string_view token);
    Result<void> read_face(TextScanner& scanner);
    Result<void> add_waiting_faces();
    void begin_object(const TextScanner& scanner, std::vector<ObjectMark>& marks);
    [[nodiscard]] Error out_of_range(std::uint64_t face, std::size_t line,
                                     const std::string& found) const;

    ObjLines lines_;
    const ReadMeshOptions& options_;
    MeshBuilder builder_;
    std::vector<std::uint32_t> corners_;
    std::vector<WaitingFace> waiting_;
    std::vector<std::uint32_t> waiting_corners_;
    NumberColours colours_;
    std::vector<ObjectMark> objects_;
    std::vector<ObjectMark> groups_;
    std::vector<ObjectMark> materials_;
    std::size_t lines_and_points_ = 0;
    std::size_t free_form_ = 0;
    std::size_t unknown_ = 0;
    std::size_t first_unknown_ = 0;
};

Result<void> ObjReader::read_vertex(TextScanner& scanner) {
    const std::uint64_t vertex = builder_.vertices().size();
    Vec3 position;
    for (int axis = 0; axis < 3; ++axis) {
        if (scanner.at_line_end()) {
            return fail(ErrorCode::kObjTruncated, "vertex " + std::to_string(vertex) +
                                                      ": expected 3 coordinates, found " +
                                                      std::to_string(axis));
        }
        Result<void> read = builder_.read_coordinate(scanner, vertex, axis, position[axis]);
        if (!read) return at_line(lines_.number(), read.error());
    }
    builder_.add_vertex(position);
    if (!scanner.at_line_end()) read_colour(scanner, vertex);
    if (vertex < options_.max_vertices) return {};
    return at_line(lines_.number(), builder_.check_counts(vertex + 1, 0).error());
}

/// A single number is w.
void ObjReader::read_colour(TextScanner& scanner, std::uint64_t vertex) {
    const LineNumbers numbers = read_line_numbers(scanner);
    if (numbers.count == 3 || numbers.count == 4) colours_.set(vertex, numbers.three_from(0));
}

Error ObjReader::out_of_range(std::uint64_t face, std::size_t line,
                              const std::string& found) const {
    const std::size_t vertices = builder_.vertices().size();
    const std::string expected = vertices == 0
                                     ? "no index, as there are no vertices"
                                     : "an index from 1 to " + std::to_string(vertices) +
                                           " or from -" + std::to_string(vertices) + " to -1";
    return at_line(
        line, {ErrorCode::kObjIndexOutOfRange,
               "face " + std::to_string(face) + ": expected " + expected + ", found " + found});
}

/// From 0; may be that of a vertex to come.
Result<std::uint32_t> ObjReader::read_corner(std::string_view token) {
    const WrittenIndex index = parse_corner(token);
    if (!index.well_formed) {
        return fail(ErrorCode::kObjBadNumber, "face " + std::to_string(faces()) +
                                                  ": expected the indices of a corner, found " +
                                                  quoted_token(token));
    }
    const std::uint64_t vertices = builder_.vertices().size();
    const std::uint64_t limit = index.negative ? vertices : options_.max_vertices;
    if (index.magnitude == 0 || index.magnitude > limit) {
        return out_of_range(faces(), lines_.number(), quoted_token(token));
    }
    return static_cast<std::uint32_t>(index.negative ? vertices - index.magnitude
                                                     : index.magnitude - 1);
}

Result<void> ObjReader::read_face(TextScanner& scanner) {
    corners_.clear();
    std::uint32_t largest = 0;
    while (!scanner.at_line_end()) {
        // Most are plain numbers, for which read_corner does too much.
        TextScanner ahead = scanner;
        std::uint64_t index = 0;
        if (ahead.read_count(index) == NumberStatus::kOk && index - 1 < options_.max_vertices) {
            corners_.push_back(static_cast<std::uint32_t>(index - 1));
            largest = std::max(largest, corners_.back());
            scanner = ahead;
            continue;
        }
        const std::string_view token = scanner.peek_token();
        const Result<std::uint32_t> corner = read_corner(token);
        if (!corner) return corner.error();
        corners_.push_back(*corner);
        largest = std::max(largest, *corner);
        scanner.advance(token.size());
    }
    Result<void> caps = builder_.check_corners(corners_.size());
    if (caps) caps = builder_.check_counts(0, faces() + 1);
    if (!caps) return at_line(lines_.number(), caps.error());
    if (waiting_.empty() && (corners_.empty() || largest < builder_.vertices().size())) {
        const Result<void> added = builder_.add_face(corners_);
        return added ? added : at_line(lines_.number(), added.error());
    }
    waiting_.push_back(
        {static_cast<std::uint32_t>(corners_.size()), static_cast<std::uint32_t>(lines_.number())});
    waiting_corners_.insert(waiting_corners_.end(), corners_.begin(), corners_.end());
    return {};
}

Result<void> ObjReader::add_waiting_faces() {
    std::span<const std::uint32_t> rest = waiting_corners_;
    for (const WaitingFace& face : waiting_) {
        const auto corners = rest.first(face.corners);
        rest = rest.subspan(face.corners);
        for (const std::uint32_t corner : corners) {
            if (corner < builder_.vertices().size()) continue;
            return out_of_range(builder_.face_count(), face.line,
                                std::to_string(std::uint64_t{corner} + 1));
        }
        const Result<void> added = builder_.add_face(corners);
        if (!added) return at_line(face.line, added.error());
    }
    return {};
}

/// All that follows on the line is the name.
void ObjReader::begin_object(const TextScanner& scanner, std::vector<ObjectMark>& marks) {
    constexpr std::string_view kBlanks = " \t";
    std::string_view name = lines_.text();
    name.remove_prefix(name.size() - scanner.bytes_left());
    name.remove_prefix(std::min(name.find_first_not_of(kBlanks), name.size()));
    name = name.substr(0, name.find_last_not_of(kBlanks) + 1);
    marks.push_back({std::string(name), static_cast<std::uint32_t>(faces())});
}

Result<void> ObjReader::read_statement() {
    TextScanner scanner(lines_.text());
    if (scanner.at_line_end()) return {};
    const std::string_view word = scanner.peek_token();
    scanner.advance(word.size());
    // These two come so often that they are not looked up.
    if (word.size() == 1 && word[0] == 'f') return read_face(scanner);
    if (word.size() == 1 && word[0] == 'v') return read_vertex(scanner);
    switch (statement_of(word)) {
        case ObjStatement::kVertex:
            return read_vertex(scanner);
        case ObjStatement::kFace:
            return read_face(scanner);
        case ObjStatement::kObject:
            begin_object(scanner, objects_);
            break;
        case ObjStatement::kGroup:
            begin_object(scanner, groups_);
            break;
        case ObjStatement::kMaterial:
            begin_object(scanner, materials_);
            break;
        case ObjStatement::kLineOrPoint:
            ++lines_and_points_;
            break;
        case ObjStatement::kFreeForm:
            ++free_form_;
            break;
        case ObjStatement::kUnknown:
            if (unknown_++ == 0) first_unknown_ = lines_.number();
            break;
        case ObjStatement::kIgnored:
            break;
    }
    return {};
}

Result<ReadMeshResult> ObjReader::read() {
    constexpr std::size_t kLinesBetweenLooks = 4096;
    for (std::size_t lines = 0; lines_.next(); ++lines) {
        if (lines % kLinesBetweenLooks == 0 && builder_.cancelled()) {
            return MeshBuilder::cancellation();
        }
        if (Result<void> read = read_statement(); !read) return read.error();
    }
    if (Result<void> added = add_waiting_faces(); !added) return added.error();
    builder_.warn("lines_and_points_skipped", lines_and_points_,
                  plural(lines_and_points_, "line or point element") + " left out");
    builder_.warn("free_form_skipped", free_form_,
                  plural(free_form_, "curve or curved surface") + " left out");
    builder_.warn("unknown_lines", unknown_,
                  plural(unknown_, "line") + " with an unknown first word, from line " +
                      std::to_string(first_unknown_));
    builder_.set_vertex_colours(colours_.take(builder_.vertices().size()));
    ReadMeshResult read = builder_.take();
    // Groups tell of materials or of parts of objects where a file has both.
    read.objects = objects_between(objects_.empty() ? groups_ : objects_, read.mesh);
    if (!materials_.empty()) read.materials = objects_between(materials_, read.mesh);
    return read;
}

std::string_view without_byte_order_mark(std::string_view text) {
    TextScanner scanner(text);
    scanner.skip_byte_order_mark();
    return text.substr(text.size() - scanner.bytes_left());
}

}  // namespace

bool looks_like_obj(std::string_view text) {
    constexpr std::size_t kGlance = 1 << 20;
    constexpr std::size_t kStatements = 100;
    ObjLines lines(without_byte_order_mark(text.substr(0, kGlance)));
    std::size_t known = 0;
    std::size_t unknown = 0;
    while (known + unknown < kStatements && lines.next()) {
        TextScanner scanner(lines.text());
        if (scanner.at_line_end()) continue;
        const bool is_known = statement_of(scanner.peek_token()) != ObjStatement::kUnknown;
        ++(is_known ? known : unknown);
    }
    return known > unknown;
}

Result<ReadMeshResult> read_obj(std::string_view text, std::string_view name,
                                const ReadMeshOptions& options, const std::stop_token& stop) {
    if (std::optional<Error> binary = nul_byte(text, ErrorCode::kObjBinary)) {
        return named<ReadMeshResult>(name, *std::move(binary));
    }
    return named(name, ObjReader(without_byte_order_mark(text), options, stop).read());
}

}  // namespace ossuary::mesh
