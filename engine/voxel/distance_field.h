#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/voxel/bit_volume.h"

namespace ossuary::voxel {

/// The exact squared Euclidean distance, in voxels, from each voxel's centre to the centre of the
/// nearest background voxel; 0 on the background. What lies outside the volume is background.
///
/// Of each row along x only the stretch that holds set voxels is stored, in whole groups of
/// kGroup voxels: most of the space around a model takes no memory, and no time.
class DistanceField {
public:
    static constexpr int kGroup = 16;

    DistanceField() = default;
    /// All distances 0, with room for those of the volume's voxels.
    explicit DistanceField(const BitVolume& volume);

    [[nodiscard]] const Vec3i& size() const { return size_; }
    [[nodiscard]] std::uint32_t squared(const Vec3i& v) const {
        const Row& row = rows_[row_index(v.y(), v.z())];
        const bool stored = v.x() >= row.begin && v.x() < row.end;
        return stored ? squared_[row.start + static_cast<std::size_t>(v.x())] : 0;
    }
    [[nodiscard]] double distance(const Vec3i& v) const {
        return std::sqrt(static_cast<double>(squared(v)));
    }

    /// Where a row is stored: x in [begin, end), both multiples of kGroup, has its value at
    /// `start` + x.
    struct Row {
        std::size_t start = 0;
        std::int32_t begin = 0;
        std::int32_t end = 0;
    };
    [[nodiscard]] const Row& row(int y, int z) const { return rows_[row_index(y, z)]; }
    /// All stored values; those of a row are beside each other.
    [[nodiscard]] const std::vector<std::uint32_t>& values() const { return squared_; }
    [[nodiscard]] std::vector<std::uint32_t>& values() { return squared_; }
    /// By x, for the set voxels of a row only.
    [[nodiscard]] const std::uint32_t* squared_row(int y, int z) const {
        return squared_.data() + row(y, z).start;
    }

private:
    [[nodiscard]] std::size_t row_index(int y, int z) const {
        return static_cast<std::size_t>(z) * static_cast<std::size_t>(size_.y()) +
               static_cast<std::size_t>(y);
    }

    Vec3i size_ = Vec3i::Zero();
    std::vector<Row> rows_;
    std::vector<std::uint32_t> squared_;  ///< after as many that are not used as a row is long
};

}  // namespace ossuary::voxel
