#include "engine/voxel/ray_columns.h"

#include <algorithm>
#include <cmath>

namespace ossuary {
namespace {

struct Point {
    std::int64_t u, v, depth;
    bool operator<(const Point& other) const {
        return u != other.u ? u < other.u : (v != other.v ? v < other.v : depth < other.depth);
    }
};

/// Twice the signed area of (a, b, p) in the projection: positive when p is left of a -> b.
std::int64_t side_of(const Point& a, const Point& b, std::int64_t u, std::int64_t v) {
    return (b.u - a.u) * (v - a.v) - (b.v - a.v) * (u - a.u);
}

/// side_of for one edge a -> b, less 1 where a line exactly on the edge counts as right of it: all
/// lines are thought of as moved by (e, e²) for an infinitesimal e. Negative is outside.
struct EdgeFunction {
    EdgeFunction(const Point& a_, const Point& b_)
        : a(a_),
          b(b_),
          step((a.v - b.v) * kGridOne),
          bias(b.v < a.v || (b.v == a.v && b.u > a.u) ? 0 : 1) {}

    [[nodiscard]] std::int64_t at(std::int64_t u, std::int64_t v) const {
        return side_of(a, b, u, v);
    }
    /// Narrows [first, last] to the lattice steps at which the function, `start` at step 0, is
    /// inside.
    void clip(std::int64_t start, std::int64_t& first, std::int64_t& last) const {
        const std::int64_t slack = start - bias;
        if (first > last) return;
        if (slack + first * step >= 0 && slack + last * step >= 0) return;
        if (slack + first * step < 0 && slack + last * step < 0) {
            last = first - 1;
        } else if (step > 0) {
            first = (-slack + step - 1) / step;
        } else {
            last = slack / -step;
        }
    }

    Point a, b;
    std::int64_t step;  ///< change from one lattice line to the next along u
    std::int64_t bias;
};

/// The coordinate of the lattice of lines: integers k stand for k * kGridOne + offset.
struct Lattice {
    std::int64_t offset;
    [[nodiscard]] std::int64_t at_or_after(std::int64_t x) const {
        return (x - offset + kGridOne - 1) >> kGridBits;
    }
    [[nodiscard]] std::int64_t at_or_before(std::int64_t x) const {
        return (x - offset) >> kGridBits;
    }
    [[nodiscard]] std::int64_t position(std::int64_t k) const { return k * kGridOne + offset; }
};

/// Sorts by line, then by depth; ties in an order of their own, so that nothing depends on the
/// order of the triangles. Lines are bucketed by v first: three times as fast as one sort of all.
void sort_crossings(std::vector<Crossing>& crossings) {
    if (crossings.empty()) return;
    const auto [low, high] =
        std::minmax_element(crossings.begin(), crossings.end(),
                            [](const Crossing& a, const Crossing& b) { return a.v < b.v; });
    const std::int32_t first = low->v;
    std::vector<std::uint32_t> begin(static_cast<std::size_t>(high->v - first) + 2, 0);
    for (const Crossing& c : crossings) ++begin[static_cast<std::size_t>(c.v - first) + 1];
    for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
    std::vector<Crossing> sorted(crossings.size());
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    for (const Crossing& c : crossings) sorted[next[static_cast<std::size_t>(c.v - first)]++] = c;
    for (std::size_t i = 0; i + 1 < begin.size(); ++i) {
        std::sort(sorted.begin() + begin[i], sorted.begin() + begin[i + 1],
                  [](const Crossing& a, const Crossing& b) {
                      if (a.u != b.u) return a.u < b.u;
                      if (a.depth != b.depth) return a.depth < b.depth;
                      if (a.part != b.part) return a.part < b.part;
                      return a.entering > b.entering;
                  });
    }
    crossings = std::move(sorted);
}

}  // namespace

std::vector<Crossing> cast_lines(const GridMesh& mesh, std::span<const std::uint32_t> triangles,
                                 std::span<const std::uint32_t> part_of,
                                 const LineDirection& direction) {
    const auto axis = static_cast<std::size_t>(direction.axis);
    const std::int64_t shear_u = direction.shear[0];
    const std::int64_t shear_v = direction.shear[1];
    const Lattice lattice_u{kGridHalf * (1 - shear_u)};
    const Lattice lattice_v{kGridHalf * (1 - shear_v)};
    const auto project = [&](std::uint32_t index) {
        const GridPoint& p = mesh.points[index];
        const std::int64_t depth = p[axis];
        return Point{p[(axis + 1) % 3] - shear_u * depth, p[(axis + 2) % 3] - shear_v * depth,
                     depth};
    };
    std::vector<Crossing> crossings;
    for (const std::uint32_t t : triangles) {
        Point a = project(mesh.triangles[t][0]);
        Point b = project(mesh.triangles[t][1]);
        Point c = project(mesh.triangles[t][2]);
        const std::int64_t u0 = lattice_u.at_or_after(std::min({a.u, b.u, c.u}));
        const std::int64_t u1 = lattice_u.at_or_before(std::max({a.u, b.u, c.u}));
        if (u0 > u1) continue;
        const std::int64_t v0 = lattice_v.at_or_after(std::min({a.v, b.v, c.v}));
        const std::int64_t v1 = lattice_v.at_or_before(std::max({a.v, b.v, c.v}));
        if (v0 > v1) continue;
        std::int64_t area = side_of(a, b, c.u, c.v);
        if (area == 0) continue;
        // Projected counter-clockwise means facing the far end of the line: there it is left.
        const bool entering = area < 0;
        if (entering) {
            std::swap(b, c);
            area = -area;
        }
        // One starting corner for all orders of the corners keeps the rounding below the same.
        while (b < a || c < a) {
            const Point first = a;
            a = b;
            b = c;
            c = first;
        }
        const EdgeFunction ab(a, b), bc(b, c), ca(c, a);
        const auto rise_b = static_cast<double>(b.depth - a.depth);
        const auto rise_c = static_cast<double>(c.depth - a.depth);
        const auto whole = static_cast<double>(area);
        const std::int64_t start = lattice_u.position(u0);
        for (std::int64_t v = v0; v <= v1; ++v) {
            const std::int64_t position = lattice_v.position(v);
            const std::int64_t at_ab = ab.at(start, position);
            const std::int64_t at_bc = bc.at(start, position);
            const std::int64_t at_ca = ca.at(start, position);
            std::int64_t first = 0, last = u1 - u0;
            ab.clip(at_ab, first, last);
            bc.clip(at_bc, first, last);
            ca.clip(at_ca, first, last);
            for (std::int64_t i = first; i <= last; ++i) {
                const double depth = static_cast<double>(a.depth) +
                                     (static_cast<double>(at_ca + i * ca.step) * rise_b +
                                      static_cast<double>(at_ab + i * ab.step) * rise_c) /
                                         whole;
                Crossing& crossing = crossings.emplace_back();
                crossing.u = static_cast<std::int32_t>(u0 + i);
                crossing.v = static_cast<std::int32_t>(v);
                crossing.depth = static_cast<std::int32_t>(std::ceil(depth));
                crossing.part = part_of[t] & 0x3fffffffu;
                crossing.entering = entering;
            }
        }
    }
    sort_crossings(crossings);
    return crossings;
}

}  // namespace ossuary
