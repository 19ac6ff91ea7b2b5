#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "engine/core/geometry.h"

namespace ossuary::index {

/// What is seen at a point of a picture.
struct SampleHit {
    static constexpr std::uint32_t kNone = 0xFFFFFFFFu;
    std::uint32_t triangle = kNone;
    float u = 0.0f;  ///< barycentric weight of the triangle's second corner
    float v = 0.0f;  ///< and of its third
};

/// A square picture's pixels that are looked at, each at side * side points evenly within it.
struct SampleGrid {
    int size = 0;  ///< pixels along a side of the picture
    int side = 1;
    /// With 1 where a pixel is looked at, rows from the top; all are where it is empty.
    std::span<const std::uint8_t> mask = {};
};

/// The nearest triangle at each point, pixel by pixel that is looked at, of a pixel row by row; the
/// first of several at one depth. Triangles are those of `vertices` in pixels, x to the right and y
/// downwards, seen from +z. A point on an edge belongs to the triangles on both sides, so that
/// nothing is seen through seams. Once `stop` is requested the hits are not all found.
std::vector<SampleHit> find_sample_hits(std::span<const Vec3f> vertices,
                                        std::span<const std::array<std::uint32_t, 3>> triangles,
                                        const SampleGrid& grid, const std::stop_token& stop);

}  // namespace ossuary::index
