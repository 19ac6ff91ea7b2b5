#include "index/coloured_parts.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>

namespace ossuary::index {
namespace {

static_assert(std::endian::native == std::endian::little, "PLY is written as it lies in memory");

template <typename T>
void append(std::string& bytes, T value) {
    const auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
    bytes.append(raw.data(), raw.size());
}

}  // namespace

std::array<std::uint8_t, 3> part_colour(std::uint32_t part) {
    constexpr double kGoldenTurn = 0.61803398874989485;
    constexpr double kSaturation = 0.55, kValue = 0.92;
    const double hue = std::fmod(0.58 + kGoldenTurn * part, 1.0);
    std::array<std::uint8_t, 3> colour{};
    for (std::size_t channel = 0; channel < 3; ++channel) {
        // The usual trapezoids of the HSV model, a third of a turn apart.
        const double shifted =
            std::fmod(6.0 * hue + 4.0 * (3.0 - static_cast<double>(channel)), 6.0);
        const double trapezoid = std::clamp(std::abs(shifted - 3.0) - 1.0, 0.0, 1.0);
        const double value = kValue * (1.0 - kSaturation * (1.0 - trapezoid));
        colour[channel] = static_cast<std::uint8_t>(std::lround(255.0 * value));
    }
    return colour;
}

std::string coloured_ply(const mesh::TriangleMesh& mesh,
                         const decomposition::Segmentation& segmentation) {
    std::string ply =
        "ply\nformat binary_little_endian 1.0\nelement vertex " +
        std::to_string(mesh.vertices.size()) +
        "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
        std::to_string(mesh.triangles.size()) +
        "\nproperty list uchar uint vertex_indices\nproperty uchar red\nproperty uchar green\n"
        "property uchar blue\nend_header\n";
    for (const Vec3& vertex : mesh.vertices) {
        for (const double coordinate : {vertex.x(), vertex.y(), vertex.z()})
            append(ply, coordinate);
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        append(ply, std::uint8_t{3});
        for (const std::uint32_t corner : mesh.triangles[t]) append(ply, corner);
        for (const std::uint8_t channel : part_colour(segmentation.labels[t])) append(ply, channel);
    }
    return ply;
}

}  // namespace ossuary::index
