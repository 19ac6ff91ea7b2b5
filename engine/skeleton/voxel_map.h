#pragma once

#include <memory>

#include "engine/skeleton/thinning_grid.h"

namespace ossuary::skeleton {

/// A value for each voxel of a set. Memory is addressed like the grid but touched only where the
/// set has voxels, so that the cost follows the set and not the grid.
template <typename T>
class VoxelMap {
public:
    VoxelMap(const ThinningGrid& set, T initial)
        : values_(std::make_unique_for_overwrite<T[]>(set.shape().count())) {
        set.for_each([&](VoxelIndex v) { values_[v] = initial; });
    }

    /// @pre `v` is in the set
    [[nodiscard]] T& operator[](VoxelIndex v) { return values_[v]; }
    [[nodiscard]] const T& operator[](VoxelIndex v) const { return values_[v]; }

private:
    std::unique_ptr<T[]> values_;
};

}  // namespace ossuary::skeleton
