#include "engine/voxel/distance_field.h"

namespace ossuary::voxel {

DistanceField::DistanceField(const BitVolume& volume) : size_(volume.size()) {
    if (volume.voxel_count() == 0) return;
    const std::size_t row_length =
        (static_cast<std::size_t>(size_.x()) + kGroup - 1) / kGroup * kGroup;
    // No row starts before the first value, so that it may be addressed by x.
    std::size_t next = row_length;
    rows_.reserve(static_cast<std::size_t>(size_.y()) * static_cast<std::size_t>(size_.z()));
    for (int z = 0; z < size_.z(); ++z) {
        for (int y = 0; y < size_.y(); ++y) {
            const auto words = volume.row(y, z);
            std::size_t first = 0, last = words.size();
            while (first < last && words[first] == 0) ++first;
            if (first == last) {
                rows_.push_back({next, 0, 0});
                continue;
            }
            while (words[last - 1] == 0) --last;
            const std::size_t begin =
                (first * 64 + static_cast<std::size_t>(std::countr_zero(words[first]))) / kGroup *
                kGroup;
            const std::size_t end =
                (last * 64 - static_cast<std::size_t>(std::countl_zero(words[last - 1])) + kGroup -
                 1) /
                kGroup * kGroup;
            rows_.push_back(
                {next - begin, static_cast<std::int32_t>(begin), static_cast<std::int32_t>(end)});
            next += end - begin;
        }
    }
    squared_.assign(next, 0);
}

}  // namespace ossuary::voxel
