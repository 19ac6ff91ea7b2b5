#include "engine/mesh/read_off_binary.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/mesh/load_number.h"

namespace ossuary::mesh {
namespace {

constexpr std::size_t kValueBytes = 4;  // of integers and floats alike

struct OffBinaryLayout {
    std::endian order = std::endian::big;
    std::size_t vertex_values = 3;  ///< a vertex, coordinates and all
    std::size_t vertex_colors = 0;  ///< of these, channels of a colour
    bool counts_face_values = true;
    std::size_t face_values = 0;  ///< after the corners of a face where they are not counted
};

std::vector<OffBinaryLayout> possible_layouts(const OffHeader& header) {
    const std::size_t values = 3 + (header.has_w ? 1 : 0) + (header.has_normals ? 3 : 0) +
                               (header.has_texture_coordinates ? 2 : 0);
    constexpr std::size_t kNone = 0, kRgb = 3, kRgba = 4;
    std::vector<std::size_t> colors = {kNone};
    if (header.has_colors) colors = {kRgba, kRgb, kNone};
    std::vector<OffBinaryLayout> layouts;
    for (const std::size_t color : colors) {
        layouts.push_back({std::endian::big, values + color, color, true, 0});
    }
    for (const std::size_t color : colors) {
        for (const std::size_t face_color : {kNone, kRgb, kRgba}) {
            layouts.push_back({std::endian::little, values + color, color, false, face_color});
        }
    }
    return layouts;
}

class OffBinaryReader {
public:
    OffBinaryReader(std::string_view data, const OffHeader& header, const OffBinaryLayout& layout)
        : data_(data), header_(header), layout_(layout) {}

    /// Reads the counts; false where the data do not end with the last face.
    bool fits();
    /// @pre  fits
    Result<ReadMeshResult> read(MeshBuilder builder) const;

private:
    [[nodiscard]] std::uint32_t integer(std::size_t value) const {
        return load_number<std::uint32_t>(data_.data() + kValueBytes * value, layout_.order);
    }
    [[nodiscard]] double coordinate(std::size_t value) const {
        return double{load_number<float>(data_.data() + kValueBytes * value, layout_.order)};
    }
    [[nodiscard]] Vec3 position(std::size_t vertex) const;
    /// Geomview's are floats, OpenMesh's may be integers.
    [[nodiscard]] std::array<float, 3> color(std::size_t value) const {
        constexpr std::uint32_t kMost = 255;
        std::array<float, 3> color{};
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const std::uint32_t bits = integer(value + channel);
            color[channel] = bits <= kMost ? static_cast<float>(bits)
                                           : static_cast<float>(coordinate(value + channel));
        }
        return color;
    }
    void color_vertices(MeshBuilder& builder) const;
    void color_face(std::uint32_t face, std::size_t value, NumberColours& colors) const;
    /// How many values a face takes that begins there; nothing where that is more than there are.
    [[nodiscard]] std::optional<std::size_t> face_size(std::size_t value) const;

    std::string_view data_;
    const OffHeader& header_;
    OffBinaryLayout layout_;
    std::size_t first_vertex_ = 0;  // counted in values, as all that follow
    std::size_t first_face_ = 0;
    std::uint32_t vertices_ = 0;
    std::uint32_t faces_ = 0;
};

std::optional<std::size_t> OffBinaryReader::face_size(std::size_t value) const {
    const std::size_t values = data_.size() / kValueBytes;
    if (value >= values) return std::nullopt;
    std::size_t size = std::size_t{1} + integer(value);
    if (layout_.counts_face_values) {
        if (value + size >= values) return std::nullopt;
        size += std::size_t{1} + integer(value + size);
    } else {
        size += layout_.face_values;
    }
    if (value + size > values) return std::nullopt;
    return size;
}

bool OffBinaryReader::fits() {
    const std::size_t values = data_.size() / kValueBytes;
    const std::size_t counts = header_.names_dimension ? 1 : 0;
    first_vertex_ = counts + 3;
    if (data_.size() % kValueBytes != 0 || values < first_vertex_) return false;
    if (header_.names_dimension && integer(0) != 3) return false;
    vertices_ = integer(counts);
    faces_ = integer(counts + 1);
    first_face_ = first_vertex_ + layout_.vertex_values * vertices_;
    std::size_t at = first_face_;
    for (std::uint32_t face = 0; face < faces_; ++face) {
        const std::optional<std::size_t> size = face_size(at);
        if (!size) return false;
        at += *size;
    }
    return at == values;
}

Vec3 OffBinaryReader::position(std::size_t vertex) const {
    const std::size_t at = first_vertex_ + layout_.vertex_values * vertex;
    const Vec3 position(coordinate(at), coordinate(at + 1), coordinate(at + 2));
    return header_.has_w ? Vec3(position / coordinate(at + 3)) : position;
}

void OffBinaryReader::color_vertices(MeshBuilder& builder) const {
    if (layout_.vertex_colors == 0) return;
    const std::size_t before = 3 + (header_.has_w ? 1 : 0) + (header_.has_normals ? 3 : 0);
    NumberColours colors;
    for (std::uint32_t v = 0; v < vertices_; ++v) {
        colors.set(v, color(first_vertex_ + layout_.vertex_values * v + before));
    }
    builder.set_vertex_colours(colors.take(vertices_));
}

/// @param value  that comes after the corners
void OffBinaryReader::color_face(std::uint32_t face, std::size_t value,
                                 NumberColours& colors) const {
    const std::size_t count = layout_.counts_face_values ? integer(value) : layout_.face_values;
    if (count != 3 && count != 4) return;
    colors.set(face, color(value + (layout_.counts_face_values ? 1 : 0)));
}

Result<ReadMeshResult> OffBinaryReader::read(MeshBuilder builder) const {
    if (Result<void> caps = builder.check_counts(vertices_, faces_); !caps) return caps.error();
    builder.reserve(vertices_, faces_);
    for (std::uint32_t v = 0; v < vertices_; ++v) {
        const Vec3 at = position(v);
        if (!builder.is_in_range(at)) return builder.position_error(v, at);
        builder.add_vertex(at);
    }
    std::vector<std::uint32_t> corners;
    NumberColours colors;
    std::size_t at = first_face_;
    for (std::uint32_t face = 0; face < faces_; ++face) {
        const std::uint32_t count = integer(at);
        if (Result<void> caps = builder.check_corners(count); !caps) return caps.error();
        corners.clear();
        for (std::uint32_t corner = 0; corner < count; ++corner) {
            const std::uint32_t index = integer(at + 1 + corner);
            if (index >= vertices_) {
                return {ErrorCode::kOffIndexOutOfRange,
                        "corner " + std::to_string(corner) + " of face " + std::to_string(face) +
                            ": expected an index below " + std::to_string(vertices_) + ", found " +
                            std::to_string(index)};
            }
            corners.push_back(index);
        }
        if (Result<void> added = builder.add_face(corners); !added) return added.error();
        const std::size_t size = *face_size(at);
        color_face(face, at + 1 + count, colors);
        at += size;
    }
    color_vertices(builder);
    builder.set_face_colours(colors.take(faces_));
    return builder.take();
}

}  // namespace

Result<ReadMeshResult> read_off_binary(std::string_view data, const OffHeader& header,
                                       MeshBuilder builder) {
    for (const OffBinaryLayout& layout : possible_layouts(header)) {
        OffBinaryReader reader(data, header, layout);
        if (reader.fits()) return reader.read(std::move(builder));
    }
    return {ErrorCode::kOffBinary,
            "expected binary data of Geomview's or OpenMesh's layout, found " +
                plural(data.size(), "byte") + " that come out even in neither"};
}

}  // namespace ossuary::mesh
