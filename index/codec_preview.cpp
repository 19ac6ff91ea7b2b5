// The blob of a model's preview.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "index/blob.h"
#include "index/blob_points.h"
#include "index/bytes.h"
#include "index/codec.h"
#include "index/grid_numbers.h"
#include "index/packed_bytes.h"

namespace ossuary::index {

namespace {

/// Positions are floats as they are, not multiples of a power of two.
constexpr std::int16_t kPositionsAsTheyAre = 0x7FFF;
constexpr std::int64_t kMostPosition = 0x7FFF;

std::size_t count_colours(PreviewColours::Of of, std::size_t vertices, std::size_t triangles) {
    switch (of) {
        case PreviewColours::Of::kNothing:
            return 0;
        case PreviewColours::Of::kModel:
            return 1;
        case PreviewColours::Of::kVertices:
            return vertices;
        case PreviewColours::Of::kTriangles:
            return triangles;
        case PreviewColours::Of::kCorners:
            return 3 * triangles;
    }
    return 0;
}

/// Of the grid that all positions lie on at no more than 16 bits each, if there is one.
std::optional<int> position_grid(const std::vector<float>& positions) {
    const std::vector<double> numbers(positions.begin(), positions.end());
    const auto exponent = grid_exponent(numbers);
    if (!exponent) return {};
    for (const double number : numbers) {
        if (std::abs(grid_multiple(number, *exponent)) > kMostPosition) return {};
    }
    return exponent;
}

/// Axis by axis the differences from vertex to vertex, the lower bytes of all before the upper
/// ones.
void put_grid_positions(ByteWriter& writer, const std::vector<float>& positions, int exponent) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::string low, high;
        std::uint32_t last = 0;
        for (std::size_t i = axis; i < positions.size(); i += 3) {
            const auto now = static_cast<std::uint32_t>(
                grid_multiple(static_cast<double>(positions[i]), exponent));
            // Small differences of either sign have an upper byte of 0.
            const auto step = static_cast<std::int16_t>(now - last);
            const auto folded = static_cast<std::uint16_t>((step << 1) ^ (step >> 15));
            low += static_cast<char>(folded & 0xFF);
            high += static_cast<char>(folded >> 8);
            last = now;
        }
        writer.put_raw(low);
        writer.put_raw(high);
    }
}

std::vector<float> get_grid_positions(ByteReader& reader, std::size_t vertices, int exponent) {
    std::vector<float> positions;
    if (vertices > reader.left() / 6) {
        reader.fail();
        return positions;
    }
    positions.resize(3 * vertices);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::string_view low = reader.get_raw(vertices);
        const std::string_view high = reader.get_raw(vertices);
        std::uint16_t last = 0;
        for (std::size_t v = 0; v < vertices; ++v) {
            const auto folded = static_cast<std::uint16_t>(
                static_cast<std::uint8_t>(low[v]) | (static_cast<std::uint8_t>(high[v]) << 8));
            last = static_cast<std::uint16_t>(last + ((folded >> 1) ^ (0U - (folded & 1U))));
            positions[3 * v + axis] =
                static_cast<float>(grid_number(static_cast<std::int16_t>(last), exponent));
        }
    }
    return positions;
}

/// How far each corner is behind the first vertex that no corner before it has named: vertices come
/// in the order of their first corners, so that most of these numbers are small.
void put_corners(ByteWriter& writer, const std::vector<std::uint32_t>& corners) {
    std::uint32_t next = 0;
    for (const std::uint32_t vertex : corners) {
        writer.put_signed(static_cast<std::int64_t>(next) - vertex);
        next = std::max(next, vertex + 1);
    }
}

std::vector<std::uint32_t> get_corners(ByteReader& reader, std::size_t count,
                                       std::uint32_t vertices) {
    std::vector<std::uint32_t> corners;
    if (count > reader.left()) reader.fail();
    if (!reader.ok()) return corners;
    corners.reserve(count);
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::int64_t behind = reader.get_signed();
        if (behind > next || behind <= static_cast<std::int64_t>(next) - vertices) {
            reader.fail();
            return corners;
        }
        corners.push_back(static_cast<std::uint32_t>(next - behind));
        next = std::max(next, corners.back() + 1);
    }
    return corners;
}

Result<PreviewMesh> wrong_length_of_preview() { return corrupt_blob(kPreviewBlob, "wrong length"); }

bool is_kind_of_colours(std::uint8_t of) {
    return of <= static_cast<std::uint8_t>(PreviewColours::Of::kCorners);
}

Error unknown_colours() { return corrupt_blob(kPreviewBlob, "colours of what there is not"); }

void get_colours(ByteReader& reader, std::uint8_t of, std::size_t vertices, std::size_t triangles,
                 PreviewColours& colours) {
    colours.of = static_cast<PreviewColours::Of>(of);
    colours.bytes =
        reader.get_all<std::uint8_t>(3 * count_colours(colours.of, vertices, triangles));
}

/// Versions 1 to 3.
Result<PreviewMesh> decode_plain_preview(std::string_view payload, std::uint8_t version) {
    ByteReader reader(payload);
    const auto vertices = reader.get<std::uint32_t>();
    const auto triangles = reader.get<std::uint32_t>();
    const auto width = reader.get<std::uint8_t>();
    if (width != 2 && width != 4) return corrupt_blob(kPreviewBlob, "index width is not 2 or 4");
    PreviewMesh mesh;
    if (version >= 2) mesh.origin = get_point(reader);
    mesh.positions = reader.get_all<float>(std::size_t{3} * vertices);
    if (width == 4) {
        mesh.triangles = reader.get_all<std::uint32_t>(std::size_t{3} * triangles);
    } else {
        const auto indices = reader.get_all<std::uint16_t>(std::size_t{3} * triangles);
        mesh.triangles.assign(indices.begin(), indices.end());
    }
    if (version >= 3) {
        const auto of = reader.get<std::uint8_t>();
        if (!is_kind_of_colours(of)) return unknown_colours();
        get_colours(reader, of, vertices, triangles, mesh.colours);
    }
    if (!reader.ok() || !reader.at_end()) return wrong_length_of_preview();
    return mesh;
}

Result<PreviewMesh> decode_packed_preview(std::string_view payload) {
    ByteReader head(payload);
    const auto vertices = head.get<std::uint32_t>();
    const auto triangles = head.get<std::uint32_t>();
    PreviewMesh mesh;
    mesh.origin = get_point(head);
    const auto of = head.get<std::uint8_t>();
    const auto exponent = head.get<std::int16_t>();
    if (!head.ok()) return wrong_length_of_preview();
    if (!is_kind_of_colours(of)) return unknown_colours();
    const bool on_grid = exponent != kPositionsAsTheyAre;
    if (on_grid && (exponent < kLeastGridExponent || exponent > kMostGridExponent)) {
        return corrupt_blob(kPreviewBlob, "a grid that cannot be");
    }
    const auto unpacked = unpack_bytes(head.get_raw(head.left()));
    if (!unpacked) return corrupt_blob(kPreviewBlob, "packed bytes that cannot be unpacked");
    ByteReader reader(*unpacked);
    mesh.positions = on_grid ? get_grid_positions(reader, vertices, exponent)
                             : reader.get_all<float>(std::size_t{3} * vertices);
    mesh.triangles = get_corners(reader, std::size_t{3} * triangles, vertices);
    get_colours(reader, of, vertices, triangles, mesh.colours);
    if (!reader.ok() || !reader.at_end()) return wrong_length_of_preview();
    return mesh;
}

}  // namespace

std::string encode_preview(const PreviewMesh& mesh) {
    ByteWriter writer;
    writer.put(static_cast<std::uint32_t>(mesh.positions.size() / 3));
    writer.put(static_cast<std::uint32_t>(mesh.triangles.size() / 3));
    put_point(writer, mesh.origin);
    writer.put(static_cast<std::uint8_t>(mesh.colours.of));
    const auto exponent = position_grid(mesh.positions);
    writer.put(exponent ? static_cast<std::int16_t>(*exponent) : kPositionsAsTheyAre);
    ByteWriter columns;
    if (exponent) {
        put_grid_positions(columns, mesh.positions, *exponent);
    } else {
        columns.put_all<float>(mesh.positions);
    }
    put_corners(columns, mesh.triangles);
    columns.put_all<std::uint8_t>(mesh.colours.bytes);
    writer.put_raw(pack_bytes(columns.bytes()));
    return seal_blob(kPreviewBlob, writer.bytes());
}

Result<PreviewMesh> decode_preview(std::string_view blob) {
    const auto payload = open_blob(kPreviewBlob, blob);
    if (!payload) return payload.error();
    auto mesh = blob_version(blob) >= 4 ? decode_packed_preview(*payload)
                                        : decode_plain_preview(*payload, blob_version(blob));
    if (!mesh) return mesh;
    const bool finite = std::all_of(mesh->positions.begin(), mesh->positions.end(),
                                    [](float value) { return std::isfinite(value); });
    if (!finite || !mesh->origin.allFinite()) {
        return corrupt_blob(kPreviewBlob, "a number that is not finite");
    }
    const std::size_t vertices = mesh->positions.size() / 3;
    for (const std::uint32_t index : mesh->triangles) {
        if (index >= vertices) return corrupt_blob(kPreviewBlob, "a vertex index out of range");
    }
    return mesh;
}

}  // namespace ossuary::index
