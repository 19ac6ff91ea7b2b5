#include "engine/skeleton/point_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ossuary::skeleton {

PointCells::PointCells(std::span<const Vec3> points) {
    Box3 bounds;
    for (const Vec3& point : points) bounds.extend(point);
    constexpr int kCellsAlong = 64;
    origin_ = bounds.min();
    side_ = std::max(bounds.sizes().maxCoeff() / kCellsAlong, 1e-300);
    size_ = (bounds.sizes() / side_).array().floor().cast<int>() + 1;
    begin_.assign(static_cast<std::size_t>(size_.prod()) + 2, 0);
    // For a while, begin_[cell + 1] is where the cell goes on.
    for (const Vec3& point : points) ++begin_[index_of(cell_of(point)) + 2];
    for (std::size_t i = 2; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    points_.resize(points.size());
    for (const Vec3& point : points) points_[begin_[index_of(cell_of(point)) + 1]++] = point;
    begin_.pop_back();
}

Vec3i PointCells::cell_of(const Vec3& place) const {
    const Vec3 at = ((place - origin_) / side_).array().floor();
    return at.cwiseMax(0.0).cwiseMin((size_ - Vec3i::Ones()).cast<double>()).cast<int>();
}

std::size_t PointCells::index_of(const Vec3i& cell) const {
    return (static_cast<std::size_t>(cell.z()) * static_cast<std::size_t>(size_.y()) +
            static_cast<std::size_t>(cell.y())) *
               static_cast<std::size_t>(size_.x()) +
           static_cast<std::size_t>(cell.x());
}

void PointCells::look_into(const Vec3i& cell, const Vec3& place, std::span<double> nearest) const {
    const std::size_t index = index_of(cell);
    for (std::uint32_t i = begin_[index]; i < begin_[index + 1]; ++i) {
        insert_nearer((points_[i] - place).squaredNorm(), nearest);
    }
}

double PointCells::distance_beyond(const Vec3& place, const Vec3i& low, const Vec3i& high) const {
    double least = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        if (low[axis] > 0) {
            least = std::min(least, place[axis] - (origin_[axis] + side_ * low[axis]));
        }
        if (high[axis] + 1 < size_[axis]) {
            least = std::min(least, origin_[axis] + side_ * (high[axis] + 1) - place[axis]);
        }
    }
    // What rounding may have put into the cell beside.
    return std::max(least - 1e-9 * side_, 0.0);
}

void PointCells::find_nearest(const Vec3& place, std::span<double> nearest) const {
    const Vec3i centre = cell_of(place);
    for (int reach = 0;; ++reach) {
        const Vec3i low = (centre.array() - reach).max(0);
        const Vec3i high = (centre.array() + reach).min(size_.array() - 1);
        for (int z = low.z(); z <= high.z(); ++z) {
            for (int y = low.y(); y <= high.y(); ++y) {
                // All of the row on the outermost shell, its two ends within.
                const bool whole =
                    std::abs(z - centre.z()) == reach || std::abs(y - centre.y()) == reach;
                for (int x = low.x(); x <= high.x(); ++x) {
                    if (whole || std::abs(x - centre.x()) == reach) {
                        look_into({x, y, z}, place, nearest);
                    }
                }
            }
        }
        const double beyond = distance_beyond(place, low, high);
        if (beyond * beyond >= nearest.back()) return;
    }
}

}  // namespace ossuary::skeleton
