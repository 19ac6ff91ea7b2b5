#include "index/thumbnail/outline_mask.h"

#include <algorithm>
#include <cmath>

#include "engine/mesh/edge_table.h"

namespace ossuary::index {
namespace {

/// Marks every pixel that the segment touches, column by column.
void mark_segment(Vec3f a, Vec3f b, int size, std::vector<std::uint8_t>& mask) {
    if (a.x() > b.x()) std::swap(a, b);
    const auto cell = [&](float x) {
        return static_cast<int>(std::clamp(std::floor(x), 0.0f, static_cast<float>(size - 1)));
    };
    const float slope = b.x() > a.x() ? (b.y() - a.y()) / (b.x() - a.x()) : 0.0f;
    for (int column = cell(a.x()); column <= cell(b.x()); ++column) {
        const float left = std::max(a.x(), static_cast<float>(column));
        const float right = std::min(b.x(), static_cast<float>(column + 1));
        float enters = a.y() + slope * (left - a.x());
        float leaves = b.x() > a.x() ? a.y() + slope * (right - a.x()) : b.y();
        if (enters > leaves) std::swap(enters, leaves);
        for (int row = cell(enters); row <= cell(leaves); ++row) {
            mask[static_cast<std::size_t>(row * size + column)] = 1;
        }
    }
}

/// Which side of the edge a b the point lies on in the picture.
float side_of(const Vec3f& a, const Vec3f& b, const Vec3f& point) {
    return (b.x() - a.x()) * (point.y() - a.y()) - (b.y() - a.y()) * (point.x() - a.x());
}

bool is_outline_or_crease(const Vec3f& a, const Vec3f& b, const Vec3f& c, const Vec3f& d) {
    if (side_of(a, b, c) * side_of(a, b, d) >= 0) return true;
    constexpr float kCrease = 0.7071f;
    const Vec3f first = (b - a).cross(c - a);
    const Vec3f second = (a - b).cross(d - b);
    return std::abs(first.dot(second)) < kCrease * first.norm() * second.norm();
}

}  // namespace

std::vector<std::uint8_t> outline_mask(const mesh::TriangleMesh& mesh,
                                       std::span<const Vec3f> vertices, int size) {
    std::vector<std::uint8_t> mask(static_cast<std::size_t>(size * size), 0);
    const mesh::EdgeTable table = mesh::build_edge_table(mesh);
    const auto opposite = [&](std::uint32_t side) {
        return vertices[mesh.triangles[side / 3][(side % 3 + 2) % 3]];
    };
    for (const mesh::EdgeTable::Edge& edge : table.edges) {
        const Vec3f& a = vertices[edge.a];
        const Vec3f& b = vertices[edge.b];
        const auto sides = table.sides_of(edge);
        if (sides.size() != 2 ||
            is_outline_or_crease(a, b, opposite(sides[0]), opposite(sides[1]))) {
            mark_segment(a, b, size, mask);
        }
    }
    return mask;
}

}  // namespace ossuary::index
