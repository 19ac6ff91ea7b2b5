#include "engine/mesh/mesh_builder.h"

#include <array>
#include <cassert>
#include <charconv>
#include <cmath>

namespace ossuary::mesh {
namespace {

constexpr CornerColours kPlainCorners = {kPlainColour, kPlainColour, kPlainColour};

}  // namespace

std::string number_text(double value) {
    std::array<char, 32> digits{};
    const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    return {digits.data(), written.ptr};
}

std::string plural(std::uint64_t count, const std::string& noun) {
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

Error at_line(std::size_t line, const Error& error) {
    return {error.code, "line " + std::to_string(line) + ": " + error.message};
}

std::optional<Error> nul_byte(std::string_view text, ErrorCode code) {
    const std::size_t nul = text.find('\0');
    if (nul == std::string_view::npos) return std::nullopt;
    TextScanner before(text.substr(0, nul));
    while (before.find_token()) before.skip_rest_of_line();
    return at_line(before.line(), {code, "expected text, found a NUL byte"});
}

void MeshBuilder::reserve(std::size_t vertices, std::size_t faces) {
    mesh_.vertices.reserve(vertices);
    mesh_.triangles.reserve(faces);
    mesh_.face_of_triangle.reserve(faces);
}

Result<void> MeshBuilder::check_counts(std::uint64_t vertices, std::uint64_t faces) const {
    const auto over = [](ErrorCode code, const char* noun, std::uint64_t found,
                         std::uint64_t cap) -> Error {
        return {code, "expected at most " + std::to_string(cap) + " " + noun + ", found " +
                          std::to_string(found)};
    };
    if (vertices > options_.max_vertices) {
        return over(codes_.too_many_vertices, "vertices", vertices, options_.max_vertices);
    }
    if (faces > options_.max_faces) {
        return over(codes_.too_many_faces, "faces", faces, options_.max_faces);
    }
    return {};
}

Error MeshBuilder::too_many_corners(const std::string& found) const {
    return {codes_.too_many_corners,
            "face " + std::to_string(mesh_.face_count) + ": expected at most " +
                std::to_string(options_.max_face_corners) + " corners, found " + found};
}

Error MeshBuilder::coordinate_error(std::uint64_t vertex, int axis, NumberStatus status,
                                    const std::string& found) const {
    const std::string where = std::string(1, "xyzw"[axis]) + " of vertex " + std::to_string(vertex);
    if (status == NumberStatus::kOk) {
        return {ErrorCode::kMeshScale, where + ": expected a magnitude of at most " +
                                           number_text(options_.max_coordinate) + ", found " +
                                           found};
    }
    return {status == NumberStatus::kNonFinite ? codes_.non_finite : codes_.bad_number,
            where + ": expected a finite number, found " + found};
}

Error MeshBuilder::position_error(std::uint64_t vertex, const Vec3& position) const {
    int axis = 0;
    while (axis < 2 && is_in_range(position[axis])) ++axis;
    const NumberStatus status =
        std::isfinite(position[axis]) ? NumberStatus::kOk : NumberStatus::kNonFinite;
    return coordinate_error(vertex, axis, status, number_text(position[axis]));
}

Result<void> MeshBuilder::add_polygon(std::span<const std::uint32_t> corners) {
    const std::uint32_t face = mesh_.face_count++;
    if (corners.size() < 3) {
        ++small_faces_;
        return {};
    }
    if (mesh_.triangles.size() + corners.size() - 2 > options_.max_triangles) {
        return {codes_.too_many_faces, "face " + std::to_string(face) + ": expected at most " +
                                           std::to_string(options_.max_triangles) +
                                           " triangles in all, found more"};
    }
    triangulator_.append(corners, mesh_.vertices, mesh_.triangles);
    mesh_.face_of_triangle.resize(mesh_.triangles.size(), face);
    return {};
}

std::size_t MeshBuilder::first_triangle_of_last_face() const {
    const std::uint32_t face = mesh_.face_count - 1;
    std::size_t first = mesh_.triangles.size();
    while (first > 0 && mesh_.face_of_triangle[first - 1] == face) --first;
    return first;
}

void MeshBuilder::colour_face(const Colour& colour) {
    mesh_.corner_colours.resize(first_triangle_of_last_face(), kPlainCorners);
    mesh_.corner_colours.resize(mesh_.triangles.size(), {colour, colour, colour});
}

void MeshBuilder::colour_face(std::span<const std::uint32_t> corners,
                              std::span<const Colour> colours) {
    assert(corners.size() == colours.size());
    const std::size_t first = first_triangle_of_last_face();
    mesh_.corner_colours.resize(first, kPlainCorners);
    colour_of_corner_.resize(mesh_.vertices.size());
    for (std::size_t i = 0; i < corners.size(); ++i) colour_of_corner_[corners[i]] = colours[i];
    for (std::size_t t = first; t < mesh_.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh_.triangles[t];
        mesh_.corner_colours.push_back(
            {colour_of_corner_[a], colour_of_corner_[b], colour_of_corner_[c]});
    }
}

/// By what was told of vertices, else of faces.
void MeshBuilder::colour_triangles() {
    if (!vertex_colours_.empty()) {
        assert(vertex_colours_.size() == mesh_.vertices.size());
        mesh_.corner_colours.reserve(mesh_.triangles.size());
        for (const auto& [a, b, c] : mesh_.triangles) {
            mesh_.corner_colours.push_back(
                {vertex_colours_[a], vertex_colours_[b], vertex_colours_[c]});
        }
    } else if (!face_colours_.empty()) {
        assert(face_colours_.size() == mesh_.face_count);
        mesh_.corner_colours.reserve(mesh_.triangles.size());
        for (const std::uint32_t face : mesh_.face_of_triangle) {
            const Colour& colour = face_colours_[face];
            mesh_.corner_colours.push_back({colour, colour, colour});
        }
    } else if (!mesh_.corner_colours.empty()) {
        mesh_.corner_colours.resize(mesh_.triangles.size(), kPlainCorners);
    }
}

ReadMeshResult MeshBuilder::take() {
    colour_triangles();
    warn("faces_under_three_corners", small_faces_,
         plural(small_faces_, "face") + " with fewer than three corners");
    warn("polygons_without_ears", triangulator_.fanned(),
         plural(triangulator_.fanned(), "polygon") + " crossing or folded, cut as a fan");
    return {std::move(mesh_), std::move(warnings_)};
}

}  // namespace ossuary::mesh
