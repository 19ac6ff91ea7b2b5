#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>

#include "engine/voxel/grid_mesh.h"
#include "engine/voxel/ray_columns.h"

namespace ossuary::voxel {

/// A corner as seen along the lines. Sheared coordinates stay below 2^30.
struct LinePoint {
    std::int32_t u, v, depth;
};
struct LineCorners {
    LinePoint a, b, c;
};

/// The coordinate of the lattice of lines: integers k stand for k * kGridOne + offset.
struct LineLattice {
    std::int32_t offset;
    [[nodiscard]] std::int32_t at_or_after(std::int32_t x) const {
        return (x - offset + kGridOne - 1) >> kGridBits;
    }
    [[nodiscard]] std::int32_t at_or_before(std::int32_t x) const {
        return (x - offset) >> kGridBits;
    }
    [[nodiscard]] std::int32_t position(std::int32_t k) const { return k * kGridOne + offset; }
};

/// The projection along one family of lines.
class LineProjection {
public:
    explicit LineProjection(const LineDirection& direction)
        : lattice_u{kGridHalf * (1 - direction.shear[0])},
          lattice_v{kGridHalf * (1 - direction.shear[1])},
          axis_(static_cast<std::size_t>(direction.axis)),
          axis_u_((axis_ + 1) % 3),
          axis_v_((axis_ + 2) % 3),
          shear_u_(direction.shear[0]),
          shear_v_(direction.shear[1]) {}

    [[nodiscard]] LinePoint operator()(const GridPoint& p) const {
        const std::int32_t depth = p[axis_];
        return {p[axis_u_] - shear_u_ * depth, p[axis_v_] - shear_v_ * depth, depth};
    }

    LineLattice lattice_u, lattice_v;

private:
    std::size_t axis_, axis_u_, axis_v_;
    std::int32_t shear_u_, shear_v_;
};

/// 1 where lines on the edge from a to b, in a counter-clockwise triangle, are outside of it: all
/// lines are thought of as moved by (e, e²) for an infinitesimal e, so that of two triangles at an
/// edge one has the lines on it.
inline std::int64_t edge_bias(const LinePoint& a, const LinePoint& b) {
    return static_cast<std::int64_t>(!((b.v < a.v) | ((b.v == a.v) & (b.u > a.u))));
}

/// Twice the signed area of (a, b, line at u and v): positive when the line is left of a -> b.
inline std::int64_t side_of(const LinePoint& a, const LinePoint& b, std::int32_t u,
                            std::int32_t v) {
    return std::int64_t{a.u - u} * (b.v - v) - std::int64_t{a.v - v} * (b.u - u);
}

/// Rounded up, but for a thousandth of a unit, so that what the arithmetic adds to a depth, which
/// depends on the order of the corners, does not push it past a voxel's centre. (Positive:
/// std::ceil is a call.)
inline std::int32_t round_depth(double depth) {
    constexpr double kSlack = 1.0 / 1024;
    return static_cast<std::int32_t>(depth + (1.0 - kSlack));
}

/// One line and one triangle. (Plain numbers: arrays go through memory and wait for it.)
class LinePlace {
public:
    /// @param u, v  position of the line
    LinePlace(const LineCorners& p, std::int32_t u, std::int32_t v)
        : weight_a_(side_of(p.b, p.c, u, v)),
          weight_b_(side_of(p.c, p.a, u, v)),
          weight_c_(side_of(p.a, p.b, u, v)),
          area_(weight_a_ + weight_b_ + weight_c_) {
        // Clockwise triangles are looked at from behind: signs and edges turn round.
        const std::int64_t flip = area_ >> 63;
        const auto turned = [flip](std::int64_t x) { return (x ^ flip) - flip; };
        outside_ = (turned(weight_a_) - (edge_bias(p.b, p.c) ^ (flip & 1))) |
                   (turned(weight_b_) - (edge_bias(p.c, p.a) ^ (flip & 1))) |
                   (turned(weight_c_) - (edge_bias(p.a, p.b) ^ (flip & 1)));
    }

    /// One test of three signs: on a fine mesh each alone would be a coin's toss.
    [[nodiscard]] bool crosses() const { return (outside_ >= 0) & (area_ != 0); }
    /// Clockwise in the projection means facing the line's start: there it is entered.
    [[nodiscard]] bool enters() const { return area_ < 0; }
    /// @pre crosses()
    [[nodiscard]] std::int32_t depth(const LineCorners& p) const {
        return round_depth(p.a.depth + (static_cast<double>(weight_b_) * (p.b.depth - p.a.depth) +
                                        static_cast<double>(weight_c_) * (p.c.depth - p.a.depth)) /
                                           static_cast<double>(area_));
    }

private:
    /// Of each corner, the signed area on the other two: barycentric, but for a factor.
    std::int64_t weight_a_, weight_b_, weight_c_;
    std::int64_t area_;
    std::int64_t outside_;
};

/// The floor of a sum that grows by the same amount again and again, over a divisor: one division
/// at the start instead of one each time.
class RunningQuotient {
public:
    RunningQuotient() = default;
    /// @param divisor  more than 0
    RunningQuotient(std::int64_t start, std::int64_t growth, std::int64_t divisor)
        : divisor_(divisor) {
        std::tie(floor_, rest_) = divide(start, divisor);
        std::tie(growth_, growth_rest_) = divide(growth, divisor);
    }
    [[nodiscard]] std::int64_t floor() const { return floor_; }
    void grow() {
        rest_ += growth_rest_;
        const std::int64_t carry = rest_ >= divisor_ ? 1 : 0;
        rest_ -= divisor_ & -carry;
        floor_ += growth_ + carry;
    }

private:
    static std::pair<std::int64_t, std::int64_t> divide(std::int64_t number, std::int64_t divisor) {
        const std::int64_t quotient = number / divisor;
        const std::int64_t rest = number - quotient * divisor;
        const std::int64_t below = rest >> 63;  // -1 where the division has rounded up
        return {quotient + below, rest + (divisor & below)};
    }

    std::int64_t divisor_ = 1, floor_ = 0, rest_ = 0, growth_ = 0, growth_rest_ = 0;
};

/// One triangle and a box of lines.
class LineRows {
public:
    /// @param u, v  position of the first line
    /// @param area  twice the signed one of the projected corners, not 0
    LineRows(const LineCorners& p, std::int32_t u, std::int32_t v, std::int64_t area)
        : edges_{area < 0 ? Edge(p.c, p.b, u, v) : Edge(p.b, p.c, u, v),
                 area < 0 ? Edge(p.a, p.c, u, v) : Edge(p.c, p.a, u, v),
                 area < 0 ? Edge(p.b, p.a, u, v) : Edge(p.a, p.b, u, v)} {
        const auto inverse = 1.0 / static_cast<double>(area);
        const double rise_b = (p.b.depth - p.a.depth) * inverse;
        const double rise_c = (p.c.depth - p.a.depth) * inverse;
        depth_ = p.a.depth + static_cast<double>(side_of(p.c, p.a, u, v)) * rise_b +
                 static_cast<double>(side_of(p.a, p.b, u, v)) * rise_c;
        depth_per_u_ = kGridOne * ((p.c.v - p.a.v) * rise_b + (p.a.v - p.b.v) * rise_c);
        depth_per_v_ = kGridOne * ((p.a.u - p.c.u) * rise_b + (p.b.u - p.a.u) * rise_c);
    }

    /// Calls visit(du, dv, depth) for the lines before `width` and `height` that cross.
    template <typename Visit>
    void visit(std::int32_t width, std::int32_t height, Visit&& visit) {
        for (std::int32_t dv = 0; dv < height; ++dv) {
            std::int64_t first = 0, last = width - 1;
            for (Edge& edge : edges_) edge.narrow(first, last);
            const double depth = depth_ + dv * depth_per_v_;
            for (std::int64_t du = first; du <= last; ++du) {
                visit(static_cast<std::int32_t>(du), dv,
                      round_depth(depth + static_cast<double>(du) * depth_per_u_));
            }
        }
    }

private:
    /// Where lines are left of a -> b, row by row.
    class Edge {
    public:
        Edge(const LinePoint& a, const LinePoint& b, std::int32_t u, std::int32_t v)
            : sign_(a.v > b.v ? 1 : (a.v < b.v ? -1 : 0)),
              slack_(side_of(a, b, u, v) - edge_bias(a, b), std::int64_t{b.u - a.u} * kGridOne,
                     std::max<std::int64_t>(std::int64_t{sign_} * (a.v - b.v) * kGridOne, 1)) {}

        /// Narrows [first, last] to where slack + change * du is not negative in this row, and goes
        /// on to the next.
        void narrow(std::int64_t& first, std::int64_t& last) {
            const std::int64_t floor = slack_.floor();
            const std::int64_t none = floor < 0 ? -1 : last;
            first = std::max(first, sign_ > 0 ? -floor : 0);
            last = std::min(last, sign_ > 0 ? last : (sign_ < 0 ? floor : none));
            slack_.grow();
        }

    private:
        int sign_;               ///< of the change from one line to the next
        RunningQuotient slack_;  ///< over the size of that change
    };

    std::array<Edge, 3> edges_;
    double depth_, depth_per_u_, depth_per_v_;
};

}  // namespace ossuary::voxel
