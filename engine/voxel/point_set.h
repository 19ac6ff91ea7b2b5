#pragma once

#include <cstddef>
#include <vector>

#include "engine/core/geometry.h"

namespace ossuary::voxel {

/// How nanoflann sees points, which have to outlive it.
struct PointSet {
    const std::vector<Vec3>& points;
    [[nodiscard]] std::size_t kdtree_get_point_count() const { return points.size(); }
    [[nodiscard]] double kdtree_get_pt(std::size_t index, std::size_t axis) const {
        return points[index][static_cast<Eigen::Index>(axis)];
    }
    template <typename Box>
    bool kdtree_get_bbox(Box&) const {
        return false;
    }
};

}  // namespace ossuary::voxel
