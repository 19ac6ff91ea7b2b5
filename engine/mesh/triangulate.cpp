#include "engine/mesh/triangulate.h"

#include <cassert>
#include <cmath>

namespace ossuary::mesh {
namespace {

using Vec2 = Eigen::Vector2d;

/// Twice the signed area of the triangle a b c.
double cross(const Vec2& a, const Vec2& b, const Vec2& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool contains(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& point) {
    return cross(a, b, point) >= 0 && cross(b, c, point) >= 0 && cross(c, a, point) >= 0;
}

}  // namespace

void PolygonTriangulator::append(std::span<const std::uint32_t> polygon,
                                 const std::vector<Vec3>& vertices,
                                 std::vector<TriangleMesh::Triangle>& triangles) {
    assert(polygon.size() >= 3);
    const bool has_area = polygon.size() > 3 && project(polygon, vertices);
    if (has_area && !is_convex()) {
        clip_ears(polygon, triangles);
        return;
    }
    if (!has_area || !flat_) {
        for (std::size_t i = 2; i < polygon.size(); ++i) {
            triangles.push_back({polygon[0], polygon[i - 1], polygon[i]});
        }
        return;
    }
    const std::size_t count = polygon.size();
    const auto greatest = std::max_element(polygon.begin(), polygon.end()) - polygon.begin();
    const auto corner = [&](std::size_t i) {
        return polygon[(static_cast<std::size_t>(greatest) + i) % count];
    };
    const bool forwards = corner(1) < corner(count - 1);
    for (std::size_t step = 2; step < count; ++step) {
        const std::size_t i = forwards ? step : count + 1 - step;
        triangles.push_back({corner(0), corner(i - 1), corner(i)});
    }
}

/// Drops the axis along which the polygon's normal is longest; false where it has no area.
bool PolygonTriangulator::project(std::span<const std::uint32_t> polygon,
                                  const std::vector<Vec3>& vertices) {
    const Vec3& origin = vertices[polygon[0]];
    Vec3 normal = Vec3::Zero();
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        normal += (vertices[polygon[i - 1]] - origin).cross(vertices[polygon[i]] - origin);
    }
    Eigen::Index axis = 0;
    if (!(normal.cwiseAbs().maxCoeff(&axis) > 0)) return false;
    Eigen::Index u = (axis + 1) % 3;
    Eigen::Index v = (axis + 2) % 3;
    if (normal[axis] < 0) std::swap(u, v);
    points_.clear();
    double reach = 0.0, height = 0.0;
    for (const std::uint32_t vertex : polygon) {
        const Vec3 offset = vertices[vertex] - origin;
        points_.emplace_back(offset[u], offset[v]);
        reach = std::max(reach, offset.norm());
        height = std::max(height, std::abs(offset.dot(normal)));
    }
    constexpr double kFlat = 1e-4;  // changes the area by the square of it
    flat_ = height <= kFlat * reach * normal.norm();
    return true;
}

/// True when every corner turns left and the outline goes round once. Straight corners do not count
/// as convex: a fan could give triangles without area.
bool PolygonTriangulator::is_convex() const {
    const std::size_t count = points_.size();
    int turns_of_x = 0;
    double last_dx = 0;
    for (std::size_t i = 0; i < 2 * count; ++i) {
        const Vec2& a = points_[i % count];
        const Vec2& b = points_[(i + 1) % count];
        if (i < count && cross(a, b, points_[(i + 2) % count]) <= 0) return false;
        // Over two rounds a convex outline turns back in x at most four times, a star more often.
        const double dx = b.x() - a.x();
        if (dx == 0) continue;
        if (last_dx != 0 && (dx > 0) != (last_dx > 0)) ++turns_of_x;
        last_dx = dx;
    }
    return turns_of_x <= 4;
}

bool PolygonTriangulator::is_reflex(std::uint32_t corner) const {
    return cross(points_[previous_[corner]], points_[corner], points_[next_[corner]]) <= 0;
}

/// An ear is a convex corner whose triangle holds no other corner. Only reflex corners can lie in
/// it; those that coincide with one of its own corners (bridged holes) do not count.
bool PolygonTriangulator::is_ear(std::uint32_t corner) {
    if (reflex_[corner] != 0) return false;
    const std::uint32_t before = previous_[corner];
    const std::uint32_t after = next_[corner];
    const Vec2& a = points_[before];
    const Vec2& b = points_[corner];
    const Vec2& c = points_[after];
    spend(reflex_corners_.size());
    for (const std::uint32_t other : reflex_corners_) {
        if (reflex_[other] == 0 || other == before || other == after) continue;
        const Vec2& point = points_[other];
        if (point == a || point == b || point == c) continue;
        if (contains(a, b, c, point)) return false;
    }
    return true;
}

void PolygonTriangulator::unlink(std::uint32_t corner) {
    next_[previous_[corner]] = next_[corner];
    previous_[next_[corner]] = previous_[corner];
    reflex_[corner] = 0;
    for (const std::uint32_t neighbor : {previous_[corner], next_[corner]}) {
        no_ear_[neighbor] = 0;
        if (reflex_[neighbor] != 0 && !is_reflex(neighbor)) reflex_[neighbor] = 0;
    }
}

void PolygonTriangulator::clip_ears(std::span<const std::uint32_t> polygon,
                                    std::vector<TriangleMesh::Triangle>& triangles) {
    const auto count = static_cast<std::uint32_t>(polygon.size());
    next_.resize(count);
    previous_.resize(count);
    reflex_.assign(count, 0);
    no_ear_.assign(count, 0);
    reflex_corners_.clear();
    for (std::uint32_t i = 0; i < count; ++i) {
        next_[i] = i + 1 == count ? 0 : i + 1;
        previous_[i] = i == 0 ? count - 1 : i - 1;
    }
    for (std::uint32_t i = 0; i < count; ++i) {
        if (!is_reflex(i)) continue;
        reflex_[i] = 1;
        reflex_corners_.push_back(i);
    }
    std::uint32_t left = count;
    std::uint32_t at = 0;
    std::uint32_t visited = 0;   // corners since the last ear
    bool all_looked_at = false;  // nothing has changed since every corner was looked at
    while (left > 3 && work_left_ > 0) {
        spend(1);
        if (visited++ == left) {
            // Only the neighbours of an ear were looked at again when it went, but another corner
            // may have become an ear too. Once all have been looked at in vain, there is none.
            if (all_looked_at) break;
            all_looked_at = true;
            visited = 0;
            no_ear_.assign(count, 0);
        }
        if (no_ear_[at] != 0 || !is_ear(at)) {
            no_ear_[at] = 1;
            at = next_[at];
            continue;
        }
        triangles.push_back({polygon[previous_[at]], polygon[at], polygon[next_[at]]});
        unlink(at);
        // Going on behind the next corner spreads the ears and avoids long thin triangles.
        at = next_[next_[at]];
        --left;
        visited = 0;
        all_looked_at = false;
    }
    if (left > 3) ++fanned_;
    const std::uint32_t apex = at;
    for (std::uint32_t i = next_[apex]; next_[i] != apex; i = next_[i]) {
        triangles.push_back({polygon[apex], polygon[i], polygon[next_[i]]});
    }
}

}  // namespace ossuary::mesh
