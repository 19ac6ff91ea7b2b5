#pragma once

#include <cstdint>
#include <vector>

#include "engine/core/geometry.h"
#include "engine/voxel/bit_volume.h"

namespace ossuary::descriptor {

/// Numbers of set voxels in boxes, each in constant time (Crow, "Summed-area tables for texture
/// mapping", 1984, in three dimensions).
class SummedVolume {
public:
    explicit SummedVolume(const voxel::BitVolume& solid);

    /// Set voxels v with low <= v < high; what lies outside the volume is empty.
    [[nodiscard]] std::uint32_t count(const Vec3i& low, const Vec3i& high) const;

private:
    [[nodiscard]] std::size_t index(int x, int y, int z) const {
        return (static_cast<std::size_t>(z) * static_cast<std::size_t>(size_.y()) +
                static_cast<std::size_t>(y)) *
                   static_cast<std::size_t>(size_.x()) +
               static_cast<std::size_t>(x);
    }

    Vec3i size_;  // one more than the volume's
    std::vector<std::uint32_t> sums_;
};

}  // namespace ossuary::descriptor
