#pragma once

#include <array>
#include <cstdint>
#include <stop_token>
#include <vector>

#include "engine/voxel/distance_field.h"

namespace ossuary::voxel {

/// A stretch of voxel groups along y or z, each with a set voxel in it; the groups before and after
/// are background or outside.
struct GroupColumn {
    std::size_t length = 0;
    const std::size_t* places =
        nullptr;  ///< where each group is stored, into DistanceField::values
};

/// The groups of a volume's rows (DistanceField::kGroup voxels along x) that hold set voxels, as
/// columns: what the passes along y and z of a distance transform have to look at.
class GroupColumns {
public:
    GroupColumns(const BitVolume& volume, const DistanceField& field);

    /// Calls `visit(GroupColumn)` for every column along an axis, 1 for y and 2 for z, until `stop`
    /// is requested.
    template <typename Visit>
    void for_each(int axis, const std::stop_token& stop, Visit&& visit) {
        const auto a = static_cast<std::size_t>(axis - 1);
        const int length = size_[axis];
        const std::size_t words = (static_cast<std::size_t>(length) + 63) / 64;
        const int across = size_[3 - axis];
        std::size_t line = 0;
        for (int other = 0; other < across && !stop.stop_requested(); ++other) {
            for (int group = 0; group < groups_; ++group, ++line) {
                const std::span<const std::uint64_t> bits(set_[a].data() + line * words, words);
                for_each_run(bits, length, false, [&](int begin, int end) {
                    for (int i = begin; i < end; ++i) {
                        const auto& row = axis == 1 ? field_.row(i, other) : field_.row(other, i);
                        places_[static_cast<std::size_t>(i - begin)] =
                            row.start + static_cast<std::size_t>(group * DistanceField::kGroup);
                    }
                    visit(GroupColumn{static_cast<std::size_t>(end - begin), places_.data()});
                });
            }
        }
    }

private:
    const DistanceField& field_;
    Vec3i size_;
    int groups_;
    /// Along y by (z, group), along z by (y, group): a bit a group that holds something.
    std::array<std::vector<std::uint64_t>, 2> set_;
    std::vector<std::size_t> places_;
};

}  // namespace ossuary::voxel
