#include "engine/voxel/thin_lines.h"

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

#include "engine/voxel/morphology.h"

namespace ossuary::voxel {
namespace {

bool is_long(const GridPoint& a, const GridPoint& b) {
    return std::abs(a[0] - b[0]) > kLongEdge || std::abs(a[1] - b[1]) > kLongEdge ||
           std::abs(a[2] - b[2]) > kLongEdge;
}

/// The union of many rectangles as a running sum over their corners.
class BoxUnion {
public:
    explicit BoxUnion(BitVolume& lines)
        : lines_(lines),
          width_(static_cast<std::size_t>(lines.size().x()) + 1),
          corners_(width_ * (static_cast<std::size_t>(lines.size().y()) + 1), 0) {}

    /// Adds the lines with first and last u and first and last v.
    void add(const std::pair<int, int>& u, const std::pair<int, int>& v) {
        ++corner(u.first, v.first);
        --corner(u.second + 1, v.first);
        --corner(u.first, v.second + 1);
        ++corner(u.second + 1, v.second + 1);
    }
    /// Sets the lines that are in some rectangle.
    void set() {
        std::vector<std::int32_t> above(width_, 0);
        for (int v = 0; v < lines_.size().y(); ++v) {
            std::int32_t here = 0;
            for (int u = 0; u < lines_.size().x(); ++u) {
                std::int32_t& column = above[static_cast<std::size_t>(u)];
                column += corner(u, v);
                here += column;
                if (here > 0) lines_.set(u, v, 0);
            }
        }
    }

private:
    std::int32_t& corner(int u, int v) {
        return corners_[static_cast<std::size_t>(v) * width_ + static_cast<std::size_t>(u)];
    }
    BitVolume& lines_;
    std::size_t width_;
    std::vector<std::int32_t> corners_;
};

}  // namespace

std::vector<std::uint32_t> find_thin_places(const GridMesh& mesh, const BitVolume& solid) {
    std::vector<std::uint8_t> is_thin;
    is_thin.reserve(mesh.points.size());
    for (const GridPoint& p : mesh.points) {
        is_thin.push_back(is_near_thick_part(solid, mesh.voxel_of(p)) ? 0 : 1);
    }
    std::vector<std::uint32_t> places;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        if ((is_thin[a] | is_thin[b] | is_thin[c]) != 0 ||
            is_long(mesh.points[a], mesh.points[b]) || is_long(mesh.points[b], mesh.points[c]) ||
            is_long(mesh.points[c], mesh.points[a])) {
            places.push_back(t);
        }
    }
    return places;
}

LineSubset lines_past(const GridMesh& mesh, const std::vector<std::uint32_t>& candidates,
                      const std::vector<std::uint32_t>& thin_places, int axis) {
    const auto axis_u = static_cast<std::size_t>((axis + 1) % 3);
    const auto axis_v = static_cast<std::size_t>((axis + 2) % 3);
    LineSubset past;
    past.lines =
        BitVolume({mesh.size[static_cast<int>(axis_u)], mesh.size[static_cast<int>(axis_v)], 1});
    if (thin_places.empty()) return past;
    std::vector<std::uint8_t> is_thin(mesh.triangles.size(), 0);
    BoxUnion boxes(past.lines);
    for (const std::uint32_t t : thin_places) {
        is_thin[t] = 1;
        const auto [a, b, c] = mesh.triangles[t];
        const auto range = [&, p = a, q = b, r = c](std::size_t i) {
            const auto [low, high] =
                std::minmax({mesh.points[p][i], mesh.points[q][i], mesh.points[r][i]});
            return std::pair((low >> kGridBits) - 1, (high >> kGridBits) + 1);
        };
        boxes.add(range(axis_u), range(axis_v));
    }
    boxes.set();
    // Of a triangle that is no thin place, and so not long, one corner tells.
    BitVolume around = past.lines;
    for (int i = 0; i <= kLongEdge / kGridOne; ++i) around = dilate(around);
    std::vector<std::uint8_t> is_near(mesh.points.size());
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        const GridPoint& p = mesh.points[i];
        is_near[i] = around.test(p[axis_u] >> kGridBits, p[axis_v] >> kGridBits, 0) ? 1 : 0;
    }
    past.triangles.resize(candidates.size());
    std::size_t count = 0;
    for (const std::uint32_t t : candidates) {
        past.triangles[count] = t;
        count += (is_near[mesh.triangles[t][0]] | is_thin[t]) != 0 ? 1 : 0;
    }
    past.triangles.resize(count);
    return past;
}

}  // namespace ossuary::voxel
