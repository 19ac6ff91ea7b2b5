#pragma once

#include <cstddef>
#include <vector>

#include "engine/skeleton/thinning_grid.h"
#include "engine/voxel/distance_field.h"

namespace ossuary::skeleton {

/// A distance field by the indices of a padded shape.
class PaddedDistance {
public:
    PaddedDistance(const voxel::DistanceField& distance, const PaddedShape& shape)
        : values_(distance.values().data()), row_(shape.row()) {
        const Vec3i size = distance.size();
        rows_in_plane_ = static_cast<std::uint32_t>(size.y()) + 2;
        starts_.resize(rows_in_plane_ * (static_cast<std::size_t>(size.z()) + 2), 0);
        for (int z = 0; z < size.z(); ++z) {
            for (int y = 0; y < size.y(); ++y) {
                const VoxelIndex first = shape.index(0, y, z);
                starts_[first / row_] = static_cast<std::ptrdiff_t>(distance.row(y, z).start) -
                                        static_cast<std::ptrdiff_t>(first);
            }
        }
    }

    /// The number of the row that holds a voxel; rows beside it are 1, planes `rows_in_plane` away.
    [[nodiscard]] std::uint32_t row_of(VoxelIndex v) const { return v / row_; }
    [[nodiscard]] std::uint32_t rows_in_plane() const { return rows_in_plane_; }

    /// @pre `v` is a set voxel of the volume that the field was made of
    [[nodiscard]] std::uint32_t squared(VoxelIndex v) const { return squared(v, row_of(v)); }
    [[nodiscard]] std::uint32_t squared(VoxelIndex v, std::uint32_t row) const {
        return *place_of(v, row);
    }
    [[nodiscard]] const std::uint32_t* place_of(VoxelIndex v, std::uint32_t row) const {
        return values_ + (starts_[row] + static_cast<std::ptrdiff_t>(v));
    }

private:
    const std::uint32_t* values_;
    std::uint32_t row_;
    std::uint32_t rows_in_plane_ = 0;
    std::vector<std::ptrdiff_t> starts_;  ///< what to add to an index, by row
};

}  // namespace ossuary::skeleton
