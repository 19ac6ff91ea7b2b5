#include "engine/voxel/morphology.h"

#include <vector>

namespace ossuary {
namespace {

/// The unused high bits of a row's last word.
std::uint64_t last_word_mask(int size) {
    const int used = size & 63;
    return used == 0 ? ~std::uint64_t{0} : (std::uint64_t{1} << used) - 1;
}

void complement(BitVolume& volume) {
    const std::uint64_t mask = last_word_mask(volume.size().x());
    for (int z = 0; z < volume.size().z(); ++z) {
        for (int y = 0; y < volume.size().y(); ++y) {
            const auto row = volume.row(y, z);
            for (std::uint64_t& word : row) word = ~word;
            if (!row.empty()) row.back() &= mask;
        }
    }
}

/// Each block of `stride` words is united with the ones before and after it.
void spread(std::span<std::uint64_t> words, std::size_t stride) {
    std::vector<std::uint64_t> before(stride, 0);
    for (std::size_t block = 0; block < words.size(); block += stride) {
        for (std::size_t w = 0; w < stride; ++w) {
            const std::uint64_t here = words[block + w];
            const std::uint64_t after =
                block + stride < words.size() ? words[block + stride + w] : 0;
            words[block + w] = before[w] | here | after;
            before[w] = here;
        }
    }
}

}  // namespace

// Axis by axis, 64 voxels at a time, in place along y and z: fresh memory costs more than the work.
BitVolume dilate(const BitVolume& volume) {
    const Vec3i size = volume.size();
    if (volume.voxel_count() == 0) return volume;
    const std::uint64_t mask = last_word_mask(size.x());
    BitVolume result(size);
    for (int z = 0; z < size.z(); ++z) {
        for (int y = 0; y < size.y(); ++y) {
            const auto in = volume.row(y, z);
            const auto out = result.row(y, z);
            for (std::size_t w = 0; w < out.size(); ++w) {
                out[w] = in[w] | (in[w] << 1) | (in[w] >> 1);
                if (w > 0) out[w] |= in[w - 1] >> 63;
                if (w + 1 < out.size()) out[w] |= in[w + 1] << 63;
            }
            out.back() &= mask;
        }
    }
    const std::size_t row = volume.words_per_row();
    const std::size_t slice = row * static_cast<std::size_t>(size.y());
    for (int z = 0; z < size.z(); ++z) {
        spread(result.words().subspan(static_cast<std::size_t>(z) * slice, slice), row);
    }
    spread(result.words(), slice);
    return result;
}

BitVolume erode(const BitVolume& volume) {
    BitVolume outside = volume;
    complement(outside);
    BitVolume result = dilate(outside);
    complement(result);
    return result;
}

BitVolume thick_parts(const BitVolume& volume) {
    const Vec3i size = volume.size();
    if (size.minCoeff() < 2) return BitVolume(size);
    // Each block is known by its first voxel until the second pass spreads it out.
    BitVolume result(size);
    const auto with_next = [](std::span<const std::uint64_t> row, std::size_t w) {
        return row[w] & ((row[w] >> 1) | (w + 1 < row.size() ? row[w + 1] << 63 : 0));
    };
    for (int z = 0; z + 1 < size.z(); ++z) {
        for (int y = 0; y + 1 < size.y(); ++y) {
            const auto out = result.row(y, z);
            for (std::size_t w = 0; w < out.size(); ++w) {
                const std::uint64_t here = with_next(volume.row(y, z), w);
                if (here == 0) continue;
                out[w] = here & with_next(volume.row(y + 1, z), w) &
                         with_next(volume.row(y, z + 1), w) &
                         with_next(volume.row(y + 1, z + 1), w);
            }
        }
    }
    // Backwards, so that what a row takes from earlier ones is still as the first pass left it.
    for (int z = size.z() - 1; z >= 0; --z) {
        for (int y = size.y() - 1; y >= 0; --y) {
            const auto row = result.row(y, z);
            for (std::size_t w = 0; w < row.size(); ++w) {
                if (y > 0) row[w] |= result.row(y - 1, z)[w];
                if (z > 0) row[w] |= result.row(y, z - 1)[w];
                if (y > 0 && z > 0) row[w] |= result.row(y - 1, z - 1)[w];
            }
            for (std::size_t w = row.size(); w-- > 0;) {
                row[w] |= (row[w] << 1) | (w > 0 ? row[w - 1] >> 63 : 0);
            }
        }
    }
    return result;
}

}  // namespace ossuary
