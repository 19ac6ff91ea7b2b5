#include "engine/mesh/read_ply.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/named.h"
#include "engine/mesh/mesh_builder.h"
#include "engine/mesh/ply_body.h"
#include "engine/mesh/ply_header.h"

namespace ossuary::mesh {
namespace {

constexpr ReaderCodes kPlyCodes = {ErrorCode::kPlyTooManyVertices, ErrorCode::kPlyTooManyFaces,
                                   ErrorCode::kPlyTooManyCorners, ErrorCode::kPlyBadNumber,
                                   ErrorCode::kPlyNonFinite};

/// Between looks at the stop token, so that a long list ends soon, too.
constexpr std::uint64_t kValuesBetweenLooks = 65'536;

/// What a colour is before any channel is read, and stays where one is missing.
constexpr std::array<float, 3> kNoColour = {std::numeric_limits<float>::quiet_NaN(),
                                            std::numeric_limits<float>::quiet_NaN(),
                                            std::numeric_limits<float>::quiet_NaN()};

enum class PlyRole { kVertices, kFaces, kStrips, kOther };

PlyRole role_of(const PlyElement& element) {
    if (element.name == "vertex") return PlyRole::kVertices;
    if (element.name == "face") return PlyRole::kFaces;
    return element.name == "tristrips" ? PlyRole::kStrips : PlyRole::kOther;
}

bool is_corner_list(const PlyProperty& property) {
    return property.meaning == PlyMeaning::kCorners;
}

bool is_coordinate(const PlyProperty& property) { return property.meaning <= PlyMeaning::kZ; }

bool is_channel(const PlyProperty& property) {
    return property.meaning >= PlyMeaning::kRed && property.meaning <= PlyMeaning::kBlue;
}

/// What the whole of a channel is; floats are as their file has them (NumberColours).
double whole_channel(PlyType type) {
    switch (type) {
        case PlyType::kUint16:
            return 65'535.0;
        case PlyType::kFloat32:
        case PlyType::kFloat64:
            return 1.0;
        default:
            return 255.0;
    }
}

/// Reads the data that follow the header.
template <typename Body>
class PlyReader {
public:
    PlyReader(Body body, const PlyHeader& header, MeshBuilder builder)
        : body_(std::move(body)), header_(header), builder_(std::move(builder)) {}

    Result<ReadMeshResult> read();

private:
    /// The entry that is being read, for messages.
    struct Place {
        const PlyElement& element;
        std::uint64_t entry;
    };

    [[nodiscard]] Error fail(ErrorCode code, const Place& place, const std::string& text) const {
        return {code, body_.place() + place.element.name + " " + std::to_string(place.entry) +
                          ": " + text};
    }
    [[nodiscard]] Error bad_value(PlyStatus status, const Place& place,
                                  const PlyProperty& property) const;
    Result<void> check_element(const PlyElement& element) const;
    Result<void> check_room(const PlyElement& element) const;
    Result<void> pass(bool vertices, bool surfaces);
    Result<void> read_element(const PlyElement& element, PlyRole role);
    template <bool kColoured>
    Result<void> read_vertex(const Place& place);
    template <bool kColoured>
    Result<void> read_surface(const Place& place, bool strips);
    template <bool kColoured>
    Result<void> read_entry(const Place& place, PlyRole role);
    Result<void> skip(const Place& place, const PlyProperty& property);
    Result<void> read_channel(const Place& place, const PlyProperty& property,
                              std::array<float, 3>& colour);
    Result<std::uint64_t> read_list_size(const Place& place, const PlyProperty& property);
    Result<void> read_polygon(const Place& place, const PlyProperty& property);
    Result<void> read_strips(const Place& place, const PlyProperty& property);
    Result<std::uint32_t> to_index(const Place& place, double value) const;
    Result<void> add_strip_corner(std::uint32_t vertex);

    Body body_;
    const PlyHeader& header_;
    MeshBuilder builder_;
    std::vector<std::uint32_t> corners_;
    NumberColours vertex_colours_;
    NumberColours face_colours_;
    std::array<std::uint32_t, 2> last_{};  // corners of the strip
    std::uint64_t strip_corners_ = 0;
};

template <typename Body>
Error PlyReader<Body>::bad_value(PlyStatus status, const Place& place,
                                 const PlyProperty& property) const {
    if (status == PlyStatus::kEnds) {
        return fail(ErrorCode::kPlyTruncated, place,
                    "expected " + property.name + ", found the end of the file");
    }
    const bool non_finite = status == PlyStatus::kNonFinite && is_coordinate(property);
    return fail(non_finite ? ErrorCode::kPlyNonFinite : ErrorCode::kPlyBadNumber, place,
                property.name + ": expected a finite number, found " + quoted_token(body_.found()));
}

/// Whether an element has what is read of it, and no more entries than may be.
template <typename Body>
Result<void> PlyReader<Body>::check_element(const PlyElement& element) const {
    const auto lacks = [&](const std::string& what) -> Error {
        return at_line(element.line,
                       {ErrorCode::kPlyHeader, "expected " + what + " among the properties of " +
                                                   element.name + ", found none"});
    };
    const PlyRole role = role_of(element);
    if (element.count == 0 || role == PlyRole::kOther) return {};
    if (role == PlyRole::kVertices) {
        for (const PlyMeaning axis : {PlyMeaning::kX, PlyMeaning::kY, PlyMeaning::kZ}) {
            const bool has =
                std::any_of(element.properties.begin(), element.properties.end(),
                            [&](const PlyProperty& property) { return property.meaning == axis; });
            if (!has) return lacks(std::string(1, "xyz"[static_cast<std::size_t>(axis)]));
        }
    } else if (std::none_of(element.properties.begin(), element.properties.end(), is_corner_list)) {
        return lacks("the list vertex_indices or vertex_index");
    }
    const Result<void> caps = builder_.check_counts(role == PlyRole::kVertices ? element.count : 0,
                                                    role == PlyRole::kFaces ? element.count : 0);
    return caps ? caps : at_line(element.line, caps.error());
}

/// Entries that cannot all be there are not made room for.
template <typename Body>
Result<void> PlyReader<Body>::check_room(const PlyElement& element) const {
    for (const PlyProperty& property : element.properties) {
        const std::uint64_t most =
            body_.most_left(property.is_list ? property.count_type : property.type);
        if (element.count <= most) continue;
        return {ErrorCode::kPlyTruncated,
                body_.place() + "expected " + plural(element.count, element.name + " entry") +
                    ", the file ends after at most " + std::to_string(most)};
    }
    return {};
}

template <typename Body>
Result<void> PlyReader<Body>::skip(const Place& place, const PlyProperty& property) {
    std::uint64_t values = 1;
    if (property.is_list) {
        const Result<std::uint64_t> size = read_list_size(place, property);
        if (!size) return size.error();
        values = *size;
    }
    while (true) {
        const std::uint64_t some = std::min(values, kValuesBetweenLooks);
        const PlyStatus status = body_.skip(property.type, some);
        if (status != PlyStatus::kOk) return bad_value(status, place, property);
        values -= some;
        if (values == 0) return {};
        if (builder_.cancelled()) return MeshBuilder::cancellation();
    }
}

template <typename Body>
Result<std::uint64_t> PlyReader<Body>::read_list_size(const Place& place,
                                                      const PlyProperty& property) {
    double size = 0;
    const PlyStatus status = body_.read(property.count_type, size);
    if (status != PlyStatus::kOk) return bad_value(status, place, property);
    if (!(size >= 0) || size != std::floor(size)) {
        return fail(ErrorCode::kPlyBadNumber, place,
                    property.name + ": expected a number of values, found " + number_text(size));
    }
    if (size > static_cast<double>(body_.most_left(property.type))) {
        return bad_value(PlyStatus::kEnds, place, property);
    }
    return static_cast<std::uint64_t>(size);
}

/// A word that is no number leaves the channel as it is.
template <typename Body>
Result<void> PlyReader<Body>::read_channel(const Place& place, const PlyProperty& property,
                                           std::array<float, 3>& colour) {
    double value = 0;
    const PlyStatus status = body_.read(property.type, value);
    if (status == PlyStatus::kEnds) return bad_value(status, place, property);
    if (status != PlyStatus::kOk) return skip(place, property);
    const auto channel =
        static_cast<std::size_t>(property.meaning) - static_cast<std::size_t>(PlyMeaning::kRed);
    colour[channel] = static_cast<float>(value / whole_channel(property.type));
    return {};
}

template <typename Body>
template <bool kColoured>
Result<void> PlyReader<Body>::read_vertex(const Place& place) {
    Vec3 position = Vec3::Zero();
    std::array<float, 3> colour = kNoColour;
    for (const PlyProperty& property : place.element.properties) {
        if (!is_coordinate(property)) {
            Result<void> done = kColoured && is_channel(property)
                                    ? read_channel(place, property, colour)
                                    : skip(place, property);
            if (!done) return done;
            continue;
        }
        const PlyStatus status =
            body_.read(property.type, position[static_cast<int>(property.meaning)]);
        if (status != PlyStatus::kOk) return bad_value(status, place, property);
    }
    if (!builder_.is_in_range(position)) {
        const Error error = builder_.position_error(place.entry, position);
        return {error.code, body_.place() + error.message};
    }
    if constexpr (kColoured) vertex_colours_.set(builder_.vertices().size(), colour);
    builder_.add_vertex(position);
    return {};
}

template <typename Body>
Result<std::uint32_t> PlyReader<Body>::to_index(const Place& place, double value) const {
    const std::size_t vertices = builder_.vertices().size();
    if (value >= 0 && value < static_cast<double>(vertices) && value == std::floor(value)) {
        return static_cast<std::uint32_t>(value);
    }
    const std::string range = vertices == 0 ? "no index, as there are no vertices"
                                            : "an index from 0 to " + std::to_string(vertices - 1);
    return fail(ErrorCode::kPlyIndexOutOfRange, place,
                "expected " + range + ", found " + number_text(value));
}

template <typename Body>
Result<void> PlyReader<Body>::read_polygon(const Place& place, const PlyProperty& property) {
    const Result<std::uint64_t> size = read_list_size(place, property);
    if (!size) return size.error();
    if (Result<void> caps = builder_.check_corners(*size); !caps) {
        return {caps.error().code, body_.place() + caps.error().message};
    }
    const auto vertices = static_cast<std::uint32_t>(builder_.vertices().size());
    if (body_.read_indices(property.type, *size, vertices, corners_)) return {};
    corners_.clear();
    for (std::uint64_t corner = 0; corner < *size; ++corner) {
        double value = 0;
        const PlyStatus status = body_.read(property.type, value);
        if (status != PlyStatus::kOk) return bad_value(status, place, property);
        const Result<std::uint32_t> index = to_index(place, value);
        if (!index) return index.error();
        corners_.push_back(*index);
    }
    return {};
}

/// Every other triangle of a strip runs the other way round.
template <typename Body>
Result<void> PlyReader<Body>::add_strip_corner(std::uint32_t vertex) {
    const std::array<std::uint32_t, 2> before = last_;
    const std::uint64_t corner = strip_corners_++;
    last_ = {before[1], vertex};
    if (corner < 2) return {};
    if (before[0] == before[1] || before[1] == vertex || vertex == before[0]) return {};
    if (Result<void> caps = builder_.check_counts(0, builder_.face_count() + std::uint64_t{1});
        !caps) {
        return caps;
    }
    const bool odd = corner % 2 == 1;
    const std::array<std::uint32_t, 3> triangle = {before[odd ? 1 : 0], before[odd ? 0 : 1],
                                                   vertex};
    return builder_.add_face(triangle);
}

template <typename Body>
Result<void> PlyReader<Body>::read_strips(const Place& place, const PlyProperty& property) {
    const Result<std::uint64_t> size = read_list_size(place, property);
    if (!size) return size.error();
    strip_corners_ = 0;
    for (std::uint64_t i = 0; i < *size; ++i) {
        if (i % kValuesBetweenLooks == 0 && builder_.cancelled()) {
            return MeshBuilder::cancellation();
        }
        double value = 0;
        const PlyStatus status = body_.read(property.type, value);
        if (status != PlyStatus::kOk) return bad_value(status, place, property);
        if (value < 0) {
            strip_corners_ = 0;
            continue;
        }
        const Result<std::uint32_t> index = to_index(place, value);
        if (!index) return index.error();
        const Result<void> added = add_strip_corner(*index);
        if (!added) return {added.error().code, body_.place() + added.error().message};
    }
    return {};
}

template <typename Body>
template <bool kColoured>
Result<void> PlyReader<Body>::read_surface(const Place& place, bool strips) {
    bool read = false;
    std::array<float, 3> colour = kNoColour;
    for (const PlyProperty& property : place.element.properties) {
        const bool corners = !read && is_corner_list(property);
        const bool channel = kColoured && is_channel(property);
        read = read || corners;
        Result<void> done = channel    ? read_channel(place, property, colour)
                            : !corners ? skip(place, property)
                            : strips   ? read_strips(place, property)
                                       : read_polygon(place, property);
        if (!done) return done;
    }
    if (strips) return {};
    if constexpr (kColoured) face_colours_.set(builder_.face_count(), colour);
    Result<void> added = builder_.add_face(corners_);
    if (added) return added;
    return {added.error().code, body_.place() + added.error().message};
}

template <typename Body>
template <bool kColoured>
Result<void> PlyReader<Body>::read_entry(const Place& place, PlyRole role) {
    if (role == PlyRole::kVertices) return read_vertex<kColoured>(place);
    if (role == PlyRole::kFaces || role == PlyRole::kStrips) {
        return read_surface<kColoured>(place, role == PlyRole::kStrips);
    }
    for (const PlyProperty& property : place.element.properties) {
        if (Result<void> skipped = skip(place, property); !skipped) return skipped;
    }
    return {};
}

/// Colours are looked for where the element has any: a seventh of the time of a binary file
/// without them.
template <typename Body>
Result<void> PlyReader<Body>::read_element(const PlyElement& element, PlyRole role) {
    constexpr std::uint64_t kEntriesBetweenLooks = 4096;
    if (element.properties.empty()) return {};
    if (Result<void> room = check_room(element); !room) return room;
    const bool coloured =
        std::any_of(element.properties.begin(), element.properties.end(), is_channel);
    builder_.reserve(role == PlyRole::kVertices ? element.count : 0,
                     role == PlyRole::kFaces ? element.count : 0);
    for (std::uint64_t entry = 0; entry < element.count; ++entry) {
        if (entry % kEntriesBetweenLooks == 0 && builder_.cancelled()) {
            return MeshBuilder::cancellation();
        }
        const Place place{element, entry};
        Result<void> read =
            coloured ? read_entry<true>(place, role) : read_entry<false>(place, role);
        if (!read) return read;
    }
    return {};
}

/// Goes through the data once and skips the elements that are not asked for.
template <typename Body>
Result<void> PlyReader<Body>::pass(bool vertices, bool surfaces) {
    body_.rewind();
    for (const PlyElement& element : header_.elements) {
        const PlyRole role = role_of(element);
        const bool wanted = role == PlyRole::kVertices ? vertices : surfaces;
        if (Result<void> read = read_element(element, wanted ? role : PlyRole::kOther); !read) {
            return read;
        }
    }
    return {};
}

template <typename Body>
Result<ReadMeshResult> PlyReader<Body>::read() {
    bool surfaces_first = false;
    bool seen_surface = false;
    for (const PlyElement& element : header_.elements) {
        if (Result<void> checked = check_element(element); !checked) return checked.error();
        const PlyRole role = role_of(element);
        if (role == PlyRole::kVertices) surfaces_first = seen_surface;
        seen_surface = seen_surface || role == PlyRole::kFaces || role == PlyRole::kStrips;
    }
    Result<void> read = pass(true, !surfaces_first);
    if (read && surfaces_first) read = pass(false, true);
    if (!read) return read.error();
    const std::size_t trailing = body_.trailing();
    if constexpr (Body::kIsText) {
        builder_.warn("trailing_text", trailing, plural(trailing, "line") + " after the data");
    } else {
        builder_.warn("trailing_bytes", trailing, plural(trailing, "byte") + " after the data");
    }
    builder_.set_vertex_colours(vertex_colours_.take(builder_.vertices().size()));
    builder_.set_face_colours(face_colours_.take(builder_.face_count()));
    return builder_.take();
}

Result<ReadMeshResult> read_ply_bytes(std::string_view bytes, const ReadMeshOptions& options,
                                      const std::stop_token& stop) {
    const Result<PlyHeader> header = read_ply_header(bytes);
    if (!header) return header.error();
    MeshBuilder builder(kPlyCodes, options, stop);
    if (header->encoding == PlyEncoding::kText) {
        return PlyReader(PlyTextBody(bytes, *header), *header, std::move(builder)).read();
    }
    return PlyReader(PlyBinaryBody(bytes, *header), *header, std::move(builder)).read();
}

}  // namespace

Result<ReadMeshResult> read_ply(std::string_view bytes, std::string_view name,
                                const ReadMeshOptions& options, const std::stop_token& stop) {
    return named(name, read_ply_bytes(bytes, options, stop));
}

}  // namespace ossuary::mesh
