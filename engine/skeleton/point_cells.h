#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/geometry.h"

namespace ossuary::skeleton {

/// Many points in a regular grid of cells, to look for the nearest ones of a place.
class PointCells {
public:
    /// @param points  not empty; kept by reference
    explicit PointCells(std::span<const Vec3> points);

    /// Lowers `nearest`, ascending squared distances, by those of the points to `place`: the same
    /// numbers as looking at every point.
    void find_nearest(const Vec3& place, std::span<double> nearest) const;

private:
    [[nodiscard]] Vec3i cell_of(const Vec3& place) const;
    [[nodiscard]] std::size_t index_of(const Vec3i& cell) const;
    void look_into(const Vec3i& cell, const Vec3& place, std::span<double> nearest) const;
    /// No point outside the cells [low, high] is nearer to `place`.
    [[nodiscard]] double distance_beyond(const Vec3& place, const Vec3i& low,
                                         const Vec3i& high) const;

    Vec3 origin_;
    double side_ = 1.0;  ///< of a cell
    Vec3i size_;
    std::vector<Vec3> points_;          ///< cell by cell
    std::vector<std::uint32_t> begin_;  ///< of each cell, and one more, where the points end
};

/// Puts a squared distance where it belongs among the ascending nearest ones; the last one goes.
inline void insert_nearer(double squared, std::span<double> nearest) {
    if (squared >= nearest.back()) return;
    std::size_t place = nearest.size() - 1;
    for (; place > 0 && nearest[place - 1] > squared; --place) nearest[place] = nearest[place - 1];
    nearest[place] = squared;
}

}  // namespace ossuary::skeleton
