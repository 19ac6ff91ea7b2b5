#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "engine/voxel/bit_volume.h"

namespace ossuary::voxel {

/// Voxels that come in any order, also repeatedly: a list while they are few, as they nearly always
/// are, and a volume of bits once that takes no more memory.
class VoxelSet {
public:
    /// @param size  of the grid
    explicit VoxelSet(const Vec3i& size)
        : size_(size),
          most_listed_(std::max<std::size_t>(
              1024, static_cast<std::size_t>(size.y()) * static_cast<std::size_t>(size.z()) *
                        ((static_cast<std::size_t>(size.x()) + 63) / 64))) {}

    void add(const Vec3i& voxel) {
        if (bits_.voxel_count() > 0) {
            bits_.set(voxel);
            return;
        }
        listed_.push_back(voxel);
        if (listed_.size() > most_listed_) pour();
    }

    [[nodiscard]] bool empty() const { return listed_.empty() && bits_.voxel_count() == 0; }

    /// Calls visit(Vec3i) for each voxel, perhaps repeatedly.
    template <typename Visit>
    void for_each(Visit&& visit) const {
        for (const Vec3i& voxel : listed_) visit(voxel);
        if (bits_.voxel_count() > 0) for_each_voxel(bits_, visit);
    }

private:
    void pour() {
        bits_ = BitVolume(size_);
        for (const Vec3i& voxel : listed_) bits_.set(voxel);
        listed_ = {};
    }

    Vec3i size_;
    std::size_t most_listed_;
    std::vector<Vec3i> listed_;
    BitVolume bits_;
};

}  // namespace ossuary::voxel
