#include "engine/mesh/write_mesh.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <vector>

#include "engine/core/whole_file.h"
#include "engine/mesh/colours_on.h"

namespace ossuary::mesh {
namespace {

template <typename Number>
void append_number(std::string& text, Number number) {
    std::array<char, 32> digits{};
    const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), number);
    text.append(digits.data(), written.ptr);
}

void append_position(std::string& text, const Vec3& position) {
    for (int axis = 0; axis < 3; ++axis) {
        if (axis > 0) text += ' ';
        append_number(text, position[axis]);
    }
    text += '\n';
}

void append_corners(std::string& text, const TriangleMesh::Triangle& triangle,
                    std::uint32_t first_index) {
    for (const std::uint32_t vertex : triangle) {
        text += ' ';
        append_number(text, std::uint64_t{vertex} + first_index);
    }
    text += '\n';
}

template <typename Number>
void append_bytes(std::string& bytes, Number number) {
    auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
    if constexpr (std::endian::native == std::endian::big) std::reverse(raw.begin(), raw.end());
    bytes.append(raw.data(), raw.size());
}

/// The triangles of each group, by the groups' numbers; all of them as one where there are none.
std::vector<std::vector<std::uint32_t>> members_of_groups(const TriangleMesh& mesh,
                                                          std::span<const std::uint32_t> groups) {
    std::vector<std::vector<std::uint32_t>> members(1);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::uint32_t group = groups.empty() ? 0 : groups[t];
        if (group >= members.size()) members.resize(std::size_t{group} + 1);
        members[group].push_back(t);
    }
    return members;
}

Vec3f normal_of(const TriangleMesh& mesh, std::size_t triangle) {
    const auto [a, b, c] = mesh.corners(triangle);
    const Vec3 normal = (b - a).cross(c - a);
    const double length = normal.norm();
    return length > 0 ? Vec3f((normal / length).cast<float>()) : Vec3f(Vec3f::Zero());
}

std::string to_binary_stl(const TriangleMesh& mesh) {
    constexpr std::size_t kHeader = 80;
    std::string stl(kHeader, '\0');
    append_bytes(stl, static_cast<std::uint32_t>(mesh.triangles.size()));
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (const float x : normal_of(mesh, t)) append_bytes(stl, x);
        for (const Vec3& corner : mesh.corners(t)) {
            for (const double x : corner) append_bytes(stl, static_cast<float>(x));
        }
        append_bytes(stl, std::uint16_t{0});
    }
    return stl;
}

void append_float_position(std::string& text, const Vec3f& position) {
    for (const float x : position) {
        text += ' ';
        append_number(text, x);
    }
    text += '\n';
}

/// The colours that are written, of triangles or of vertices.
struct WrittenColours {
    std::vector<Colour> of_triangles, of_vertices;
};

WrittenColours written_colours(const TriangleMesh& mesh, std::span<const Colour> colours) {
    WrittenColours written;
    if (!colours.empty()) {
        written.of_triangles.assign(colours.begin(), colours.end());
    } else if (has_flat_colours(mesh)) {
        for (const CornerColours& corners : mesh.corner_colours) {
            written.of_triangles.push_back(corners[0]);
        }
    } else {
        written.of_vertices.assign(mesh.vertices.size(), kPlainColour);
        for (std::size_t t = mesh.triangles.size(); t-- > 0;) {
            for (std::size_t corner = 0; corner < 3; ++corner) {
                written.of_vertices[mesh.triangles[t][corner]] = mesh.corner_colours[t][corner];
            }
        }
    }
    return written;
}

/// In place of the end of the line.
void append_colour(std::string& text, const Colour& colour) {
    text.pop_back();
    for (const std::uint8_t channel : colour) {
        text += ' ';
        append_number(text, std::uint32_t{channel});
    }
    text += '\n';
}

}  // namespace

std::string to_off(const TriangleMesh& mesh, std::span<const Colour> colours) {
    const WrittenColours written = written_colours(mesh, colours);
    std::string text = written.of_vertices.empty() ? "OFF\n" : "COFF\n";
    append_number(text, mesh.vertices.size());
    text += ' ';
    append_number(text, mesh.triangles.size());
    text += " 0\n";
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        append_position(text, mesh.vertices[v]);
        if (!written.of_vertices.empty()) append_colour(text, written.of_vertices[v]);
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        text += '3';
        append_corners(text, mesh.triangles[t], 0);
        if (!written.of_triangles.empty()) append_colour(text, written.of_triangles[t]);
    }
    return text;
}

std::string to_obj(const TriangleMesh& mesh, std::span<const std::uint32_t> groups,
                   const std::string& name) {
    std::string text;
    for (const Vec3& vertex : mesh.vertices) {
        text += "v ";
        append_position(text, vertex);
    }
    const auto members = members_of_groups(mesh, groups);
    for (std::size_t group = 0; group < members.size(); ++group) {
        if (!groups.empty()) text += "g " + name + std::to_string(group) + "\n";
        for (const std::uint32_t t : members[group]) {
            text += 'f';
            append_corners(text, mesh.triangles[t], 1);
        }
    }
    return text;
}

std::string to_ply(const TriangleMesh& mesh, std::span<const Colour> colours) {
    constexpr std::string_view kChannels =
        "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    const WrittenColours written = written_colours(mesh, colours);
    std::string ply = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                      std::to_string(mesh.vertices.size()) +
                      "\nproperty double x\nproperty double y\nproperty double z\n";
    if (!written.of_vertices.empty()) ply += kChannels;
    ply += "element face " + std::to_string(mesh.triangles.size()) +
           "\nproperty list uchar uint vertex_indices\n";
    if (!written.of_triangles.empty()) ply += kChannels;
    ply += "end_header\n";
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        for (const double coordinate : mesh.vertices[v]) append_bytes(ply, coordinate);
        if (written.of_vertices.empty()) continue;
        for (const std::uint8_t channel : written.of_vertices[v]) append_bytes(ply, channel);
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        append_bytes(ply, std::uint8_t{3});
        for (const std::uint32_t corner : mesh.triangles[t]) append_bytes(ply, corner);
        if (written.of_triangles.empty()) continue;
        for (const std::uint8_t channel : written.of_triangles[t]) append_bytes(ply, channel);
    }
    return ply;
}

std::string to_stl(const TriangleMesh& mesh, std::span<const std::uint32_t> groups,
                   const std::string& name) {
    if (groups.empty()) return to_binary_stl(mesh);
    std::string text;
    const auto members = members_of_groups(mesh, groups);
    for (std::size_t group = 0; group < members.size(); ++group) {
        text += "solid " + name + std::to_string(group) + "\n";
        for (const std::uint32_t t : members[group]) {
            text += "facet normal";
            append_float_position(text, normal_of(mesh, t));
            text += "outer loop\n";
            for (const Vec3& corner : mesh.corners(t)) {
                text += "vertex";
                append_float_position(text, corner.cast<float>());
            }
            text += "endloop\nendfacet\n";
        }
        text += "endsolid " + name + std::to_string(group) + "\n";
    }
    return text;
}

Result<void> write_off(const TriangleMesh& mesh, const std::filesystem::path& path) {
    return write_whole_file(path, to_off(mesh));
}

Result<void> write_obj(const TriangleMesh& mesh, const std::filesystem::path& path) {
    return write_whole_file(path, to_obj(mesh));
}

}  // namespace ossuary::mesh
