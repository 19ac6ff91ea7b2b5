#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/mesh/triangle_mesh.h"

namespace ossuary::mesh {

/// Cuts polygons into triangles; keeps its buffers from one polygon to the next.
///
/// Convex polygons become a fan. That of a flat one begins at the corner of the greatest index, in
/// an order that follows from the indices, so that the triangles are the same whichever corner a
/// file begins with and whichever way round it goes. That of a bent one begins at its first corner,
/// as in other programs: where it begins is a part of its shape. Others are cut by ear clipping in
/// the plane of their area normal (Newell's), so that a simple planar polygon is covered exactly. A
/// polygon of n corners always gives n - 2 triangles that use its corners only and keep its
/// orientation; where it is not simple (self-crossing, folded, without area) the rest that has no
/// ear left becomes a fan.
class PolygonTriangulator {
public:
    /// `max_work` bounds the steps (corners visited, points tested) over the lifetime of the
    /// object; what is left when they are spent becomes fans.
    explicit PolygonTriangulator(std::uint64_t max_work = 300'000'000) : work_left_(max_work) {}

    /// Appends the triangles of `polygon`, at least three indices into `vertices`.
    void append(std::span<const std::uint32_t> polygon, const std::vector<Vec3>& vertices,
                std::vector<TriangleMesh::Triangle>& triangles);

    /// Concave polygons that became fans, wholly or in part, because no ear was found or the work
    /// was spent.
    [[nodiscard]] std::size_t fanned() const { return fanned_; }

private:
    using Vec2 = Eigen::Vector2d;

    bool project(std::span<const std::uint32_t> polygon, const std::vector<Vec3>& vertices);
    [[nodiscard]] bool is_convex() const;
    void clip_ears(std::span<const std::uint32_t> polygon,
                   std::vector<TriangleMesh::Triangle>& triangles);
    [[nodiscard]] bool is_reflex(std::uint32_t corner) const;
    [[nodiscard]] bool is_ear(std::uint32_t corner);
    void spend(std::uint64_t steps) { work_left_ -= steps < work_left_ ? steps : work_left_; }
    void unlink(std::uint32_t corner);

    std::uint64_t work_left_;
    std::size_t fanned_ = 0;
    bool flat_ = false;         // the polygon that was projected last
    std::vector<Vec2> points_;  // counter-clockwise
    std::vector<std::uint32_t> next_;
    std::vector<std::uint32_t> previous_;
    std::vector<std::uint8_t> reflex_;
    std::vector<std::uint8_t> no_ear_;           // at the last look, which may be out of date
    std::vector<std::uint32_t> reflex_corners_;  // may name corners that are reflex no more
};

}  // namespace ossuary::mesh
