#include "engine/mesh/write_mesh.h"

#include <array>
#include <charconv>
#include <fstream>

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

Result<void> write_text(const std::string& text, const std::filesystem::path& path) {
    std::ofstream file(path, std::ios::binary);
    file.write(text.data(), static_cast<std::streamsize>(text.size()));
    file.close();
    if (!file) return {ErrorCode::kFileUnwritable, path.string() + ": cannot be written"};
    return {};
}

}  // namespace

std::string to_off(const TriangleMesh& mesh) {
    std::string text = "OFF\n";
    append_number(text, mesh.vertices.size());
    text += ' ';
    append_number(text, mesh.triangles.size());
    text += " 0\n";
    for (const Vec3& vertex : mesh.vertices) append_position(text, vertex);
    for (const TriangleMesh::Triangle& triangle : mesh.triangles) {
        text += '3';
        append_corners(text, triangle, 0);
    }
    return text;
}

std::string to_obj(const TriangleMesh& mesh) {
    std::string text;
    for (const Vec3& vertex : mesh.vertices) {
        text += "v ";
        append_position(text, vertex);
    }
    for (const TriangleMesh::Triangle& triangle : mesh.triangles) {
        text += 'f';
        append_corners(text, triangle, 1);
    }
    return text;
}

Result<void> write_off(const TriangleMesh& mesh, const std::filesystem::path& path) {
    return write_text(to_off(mesh), path);
}

Result<void> write_obj(const TriangleMesh& mesh, const std::filesystem::path& path) {
    return write_text(to_obj(mesh), path);
}

}  // namespace ossuary::mesh
