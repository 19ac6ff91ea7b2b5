#include "engine/voxel/distance_columns.h"

#include <algorithm>

namespace ossuary::voxel {

GroupColumns::GroupColumns(const BitVolume& volume, const DistanceField& field)
    : field_(field),
      size_(volume.size()),
      groups_((size_.x() + DistanceField::kGroup - 1) / DistanceField::kGroup),
      places_(static_cast<std::size_t>(std::max(size_.y(), size_.z()))) {
    const auto groups = static_cast<std::size_t>(groups_);
    const auto ny = static_cast<std::size_t>(size_.y());
    const auto nz = static_cast<std::size_t>(size_.z());
    const std::size_t words_y = (ny + 63) / 64;
    const std::size_t words_z = (nz + 63) / 64;
    set_[0].assign(nz * groups * words_y, 0);
    set_[1].assign(ny * groups * words_z, 0);
    for (std::size_t z = 0; z < nz; ++z) {
        for (std::size_t y = 0; y < ny; ++y) {
            const auto row = volume.row(static_cast<int>(y), static_cast<int>(z));
            for (std::size_t w = 0; w < row.size(); ++w) {
                if (row[w] == 0) continue;
                for (std::size_t part = 0; part < 4; ++part) {
                    if ((row[w] >> 16 * part & 0xffffu) == 0) continue;
                    const std::size_t group = w * 4 + part;
                    set_[0][(z * groups + group) * words_y + y / 64] |= std::uint64_t{1} << y % 64;
                    set_[1][(y * groups + group) * words_z + z / 64] |= std::uint64_t{1} << z % 64;
                }
            }
        }
    }
}

}  // namespace ossuary::voxel
