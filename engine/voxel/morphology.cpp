#include "engine/voxel/morphology.h"

namespace ossuary {
namespace {

/// The unused high bits of a row's last word.
std::uint64_t last_word_mask(int size) {
    const int used = size & 63;
    return used == 0 ? ~std::uint64_t{0} : (std::uint64_t{1} << used) - 1;
}

BitVolume complement(const BitVolume& volume) {
    BitVolume result(volume.size());
    const std::uint64_t mask = last_word_mask(volume.size().x());
    for (int z = 0; z < volume.size().z(); ++z) {
        for (int y = 0; y < volume.size().y(); ++y) {
            const auto in = volume.row(y, z);
            const auto out = result.row(y, z);
            for (std::size_t w = 0; w < out.size(); ++w) out[w] = ~in[w];
            if (!out.empty()) out.back() &= mask;
        }
    }
    return result;
}

void unite(std::span<std::uint64_t> to, std::span<const std::uint64_t> from) {
    for (std::size_t w = 0; w < to.size(); ++w) to[w] |= from[w];
}

}  // namespace

// Axis by axis, 64 voxels at a time.
BitVolume dilate(const BitVolume& volume) {
    const Vec3i size = volume.size();
    if (volume.voxel_count() == 0) return volume;
    const std::uint64_t mask = last_word_mask(size.x());
    BitVolume along_x(size);
    for (int z = 0; z < size.z(); ++z) {
        for (int y = 0; y < size.y(); ++y) {
            const auto in = volume.row(y, z);
            const auto out = along_x.row(y, z);
            for (std::size_t w = 0; w < out.size(); ++w) {
                out[w] = in[w] | (in[w] << 1) | (in[w] >> 1);
                if (w > 0) out[w] |= in[w - 1] >> 63;
                if (w + 1 < out.size()) out[w] |= in[w + 1] << 63;
            }
            out.back() &= mask;
        }
    }
    BitVolume along_y = along_x;
    for (int z = 0; z < size.z(); ++z) {
        for (int y = 0; y < size.y(); ++y) {
            if (y > 0) unite(along_y.row(y, z), along_x.row(y - 1, z));
            if (y + 1 < size.y()) unite(along_y.row(y, z), along_x.row(y + 1, z));
        }
    }
    BitVolume result = along_y;
    for (int z = 0; z < size.z(); ++z) {
        for (int y = 0; y < size.y(); ++y) {
            if (z > 0) unite(result.row(y, z), along_y.row(y, z - 1));
            if (z + 1 < size.z()) unite(result.row(y, z), along_y.row(y, z + 1));
        }
    }
    return result;
}

BitVolume erode(const BitVolume& volume) { return complement(dilate(complement(volume))); }

}  // namespace ossuary
