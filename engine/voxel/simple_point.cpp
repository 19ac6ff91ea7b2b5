#include "engine/voxel/simple_point.h"

#include <array>
#include <bit>

namespace ossuary::voxel {
namespace {

/// Bit dx + 1 + 3 (dy + 1) + 9 (dz + 1) of a neighbourhood is the voxel at (dx, dy, dz).
constexpr int kCells = 27;
constexpr int kCentre = 13;

constexpr int offset_sum(int a, int b) {
    const auto distance = [](int p, int q) { return p > q ? p - q : q - p; };
    return distance(a % 3, b % 3) + distance(a / 3 % 3, b / 3 % 3) + distance(a / 9, b / 9);
}
constexpr bool is_vertex_neighbor(int a, int b) {
    const auto near = [](int p, int q) { return p - q <= 1 && q - p <= 1; };
    return a != b && near(a % 3, b % 3) && near(a / 3 % 3, b / 3 % 3) && near(a / 9, b / 9);
}

struct Masks {
    std::array<std::uint32_t, kCells> by_vertices{};
    std::array<std::uint32_t, kCells> by_faces{};
    std::uint32_t faces_of_centre = 0;
    std::uint32_t eighteen = 0;
};

constexpr Masks kMasks = [] {
    Masks masks;
    for (int a = 0; a < kCells; ++a) {
        const auto i = static_cast<std::size_t>(a);
        for (int b = 0; b < kCells; ++b) {
            if (is_vertex_neighbor(a, b)) masks.by_vertices[i] |= 1u << b;
            if (offset_sum(a, b) == 1) masks.by_faces[i] |= 1u << b;
        }
        if (offset_sum(a, kCentre) == 1) masks.faces_of_centre |= 1u << a;
        if (a != kCentre && offset_sum(a, kCentre) <= 2) masks.eighteen |= 1u << a;
    }
    return masks;
}();

/// The cells of `allowed` connected to the lowest one of `seeds`.
std::uint32_t flood(std::uint32_t seeds, std::uint32_t allowed,
                    const std::array<std::uint32_t, kCells>& neighbors) {
    std::uint32_t reached = seeds & (~seeds + 1);
    std::uint32_t front = reached;
    while (front != 0) {
        std::uint32_t next = 0;
        for (; front != 0; front &= front - 1) {
            next |= neighbors[static_cast<std::size_t>(std::countr_zero(front))];
        }
        front = next & allowed & ~reached;
        reached |= front;
    }
    return reached;
}

std::uint32_t neighborhood(const BitVolume& volume, const Vec3i& v) {
    std::uint32_t cells = 0;
    int shift = 0;
    const int x = v.x() - 1;
    const auto word = static_cast<std::size_t>(x >> 6);
    const int bit = x & 63;
    for (int dz = -1; dz <= 1; ++dz) {
        for (int dy = -1; dy <= 1; ++dy, shift += 3) {
            const auto row = volume.row(v.y() + dy, v.z() + dz);
            std::uint64_t three = row[word] >> bit;
            if (bit > 61 && word + 1 < row.size()) three |= row[word + 1] << (64 - bit);
            cells |= static_cast<std::uint32_t>(three & 7) << shift;
        }
    }
    return cells;
}

}  // namespace

bool is_simple_point(const BitVolume& volume, const Vec3i& voxel) {
    const std::uint32_t object = neighborhood(volume, voxel) & ~(1u << kCentre);
    if (object == 0 || flood(object, object, kMasks.by_vertices) != object) return false;
    const std::uint32_t background = ~object & kMasks.eighteen;
    const std::uint32_t faces = background & kMasks.faces_of_centre;
    return faces != 0 && (faces & ~flood(faces, background, kMasks.by_faces)) == 0;
}

}  // namespace ossuary::voxel
