#pragma once

#include <cstddef>
#include <vector>

#include "engine/core/geometry.h"

namespace ossuary::voxel {

/// A number at each point of a grid of any spacing and direction.
struct ScalarGrid {
    Vec3i size = Vec3i::Zero();
    std::vector<float> values;   ///< x fastest, then y, then z
    Vec3 origin = Vec3::Zero();  ///< of point (0, 0, 0), world units
    /// Steps from a point to the next along x, y and z as columns, world units; may mirror.
    Mat3 axes = Mat3::Identity();

    ScalarGrid() = default;
    explicit ScalarGrid(const Vec3i& points)
        : size(points),
          values(static_cast<std::size_t>(points.x()) * static_cast<std::size_t>(points.y()) *
                 static_cast<std::size_t>(points.z())) {}

    [[nodiscard]] std::size_t index(int x, int y, int z) const {
        return (static_cast<std::size_t>(z) * static_cast<std::size_t>(size.y()) +
                static_cast<std::size_t>(y)) *
                   static_cast<std::size_t>(size.x()) +
               static_cast<std::size_t>(x);
    }
    [[nodiscard]] float at(int x, int y, int z) const { return values[index(x, y, z)]; }
    [[nodiscard]] float& at(int x, int y, int z) { return values[index(x, y, z)]; }
    [[nodiscard]] Vec3 world(const Vec3& point) const { return origin + axes * point; }
};

}  // namespace ossuary::voxel
