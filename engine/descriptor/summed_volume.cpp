#include "engine/descriptor/summed_volume.h"

namespace ossuary::descriptor {

SummedVolume::SummedVolume(const voxel::BitVolume& solid)
    : size_((solid.size().array() + 1).matrix()),
      sums_(static_cast<std::size_t>(size_.x()) * static_cast<std::size_t>(size_.y()) *
                static_cast<std::size_t>(size_.z()),
            0) {
    for (int z = 1; z < size_.z(); ++z) {
        for (int y = 1; y < size_.y(); ++y) {
            const auto row = solid.row(y - 1, z - 1);
            const std::uint32_t* before = sums_.data() + index(0, y - 1, z);
            const std::uint32_t* below = sums_.data() + index(0, y, z - 1);
            const std::uint32_t* both = sums_.data() + index(0, y - 1, z - 1);
            std::uint32_t* out = sums_.data() + index(0, y, z);
            std::uint32_t along = 0;
            for (int x = 1; x < size_.x(); ++x) {
                const auto bit = static_cast<unsigned>(x - 1);
                along += static_cast<std::uint32_t>((row[bit >> 6] >> (bit & 63U)) & 1U);
                out[x] = along + before[x] + below[x] - both[x];
            }
        }
    }
}

std::uint32_t SummedVolume::count(const Vec3i& low, const Vec3i& high) const {
    const Vec3i last = (size_.array() - 1).matrix();
    const Vec3i l = low.cwiseMax(0).cwiseMin(last);
    const Vec3i h = high.cwiseMax(l).cwiseMin(last);
    const auto at = [&](int x, int y, int z) { return sums_[index(x, y, z)]; };
    // Unsigned sums may wrap on the way; the result does not.
    return at(h.x(), h.y(), h.z()) - at(l.x(), h.y(), h.z()) - at(h.x(), l.y(), h.z()) -
           at(h.x(), h.y(), l.z()) + at(l.x(), l.y(), h.z()) + at(l.x(), h.y(), l.z()) +
           at(h.x(), l.y(), l.z()) - at(l.x(), l.y(), l.z());
}

}  // namespace ossuary::descriptor
