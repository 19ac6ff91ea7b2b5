#include "engine/voxel/morphology.h"

#include <array>
#include <vector>

namespace ossuary::voxel {
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

bool is_near_thick_part(const BitVolume& volume, const Vec3i& v) {
    const int bit = (v.x() - 2) & 63;
    const std::size_t row_words = volume.words_per_row();
    const std::size_t slice_words = row_words * static_cast<std::size_t>(volume.size().y());
    const std::uint64_t* const first = volume.row(v.y() - 2, v.z() - 2).data() + ((v.x() - 2) >> 6);
    // Bit i of pairs[z][y]: the voxels x - 2 + i and the next one of the row are set.
    std::array<std::array<std::uint64_t, 5>, 5> pairs;
    const auto look_at_row = [&](std::size_t y, std::size_t z) {
        const std::uint64_t* const words = first + y * row_words + z * slice_words;
        std::uint64_t five = words[0] >> bit;
        if (bit > 59) five |= words[1] << (64 - bit);
        pairs[z][y] = five & (five >> 1) & 15;
    };
    const auto any_block = [&](std::size_t begin, std::size_t end) {
        std::uint64_t blocks = 0;
        for (std::size_t z = begin; z + 1 < end; ++z) {
            for (std::size_t y = begin; y + 1 < end; ++y) {
                blocks |= pairs[z][y] & pairs[z][y + 1] & pairs[z + 1][y] & pairs[z + 1][y + 1];
            }
        }
        return blocks != 0;
    };
    for (std::size_t z = 1; z < 4; ++z) {
        for (std::size_t y = 1; y < 4; ++y) look_at_row(y, z);
    }
    if (any_block(1, 4)) return true;
    for (std::size_t z = 0; z < 5; ++z) {
        for (std::size_t y = 0; y < 5; ++y) look_at_row(y, z);
    }
    return any_block(0, 5);
}

}  // namespace ossuary::voxel
