#include "engine/voxel/distance_scan.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace ossuary {
namespace {

constexpr std::size_t kLanes = 16;

/// Values less 2^15: the basic vector instructions find the smaller of two 16-bit integers only
/// with a sign. Without that, the loops stay scalar.
using Lanes = std::array<std::int16_t, kLanes>;
constexpr int kShift = 1 << 15;

Lanes background() {
    Lanes lanes;
    lanes.fill(-kShift);
    return lanes;
}

/// Along x the distance to the nearer end of the run is the whole story.
void scan_row(const BitVolume& volume, int y, int z, std::uint16_t* out) {
    for_each_run(volume.row(y, z), volume.size().x(), false, [&](int begin, int end) {
        for (int x = begin; x < end; ++x) {
            const int d = std::min(x - begin + 1, end - x);
            out[x] = static_cast<std::uint16_t>(d * d);
        }
    });
}

std::size_t largest(const Lanes& lanes) {
    std::int16_t most = -kShift;
    for (const std::int16_t value : lanes) most = value > most ? value : most;
    return static_cast<std::size_t>(most + kShift);
}

/// Reads `length` groups of columns into rows 1 to length of `rows`, those of background only
/// (most, in most models) without touching the values; `bits` gives the words of the volume that
/// hold them. Returns the first and one past the last row that is not all background, 0 and 0 if
/// there is none.
template <typename Bits>
std::array<std::size_t, 2> gather(const std::uint16_t* in, std::size_t length, std::size_t stride,
                                  Bits&& bits, std::vector<Lanes>& rows) {
    std::size_t first = 0, end = 0;
    for (std::size_t i = 0; i < length; ++i, in += stride) {
        if ((bits(i) & 0xffffu) == 0) {
            if (first > 0) rows[i + 1] = background();
            continue;
        }
        for (std::size_t c = 0; c < kLanes; ++c) {
            rows[i + 1][c] = static_cast<std::int16_t>(in[c] - kShift);
        }
        if (first == 0) first = i + 1;
        end = i + 2;
    }
    if (first > 0) rows[first - 1] = rows[end] = background();
    return {first, end};
}

/// The nearest for row i of [first, end): the rows around these are background.
Lanes nearest(const std::vector<Lanes>& rows, std::size_t i, std::size_t first, std::size_t end) {
    Lanes best = rows[i];
    // Looking at the largest only at every fourth step: it takes as long as a step.
    for (std::size_t k = 1; k * k < largest(best);) {
        for (const std::size_t stop = k + 4; k < stop; ++k) {
            // Beyond the background row at either end there is nothing nearer.
            const Lanes& above = rows[std::max(i, first - 1 + k) - k];
            const Lanes& below = rows[std::min(i + k, end)];
            const auto step = static_cast<std::uint16_t>(k * k);
            for (std::size_t c = 0; c < kLanes; ++c) {
                const std::int16_t nearer = above[c] < below[c] ? above[c] : below[c];
                const auto there = static_cast<std::int16_t>(nearer + step);
                best[c] = there < best[c] ? there : best[c];
            }
        }
    }
    return best;
}

}  // namespace

std::vector<std::uint32_t> distances_by_scan(const BitVolume& volume) {
    assert(volume.size().maxCoeff() <= kMaxScanSide);
    const auto nx = static_cast<std::size_t>(volume.size().x());
    const auto ny = static_cast<std::size_t>(volume.size().y());
    const auto nz = static_cast<std::size_t>(volume.size().z());
    const std::size_t width = (nx + kLanes - 1) / kLanes * kLanes;
    std::vector<Lanes> rows(std::max(ny, nz) + 2, background());
    std::vector<std::uint16_t> planar(width * ny * nz, 0);  // distances within slices of one z
    for (std::size_t z = 0; z < nz; ++z) {
        std::uint16_t* slice = planar.data() + z * ny * width;
        for (std::size_t y = 0; y < ny; ++y) {
            scan_row(volume, static_cast<int>(y), static_cast<int>(z), slice + y * width);
        }
        for (std::size_t x = 0; x < width; x += kLanes) {
            const auto bits = [&](std::size_t y) {
                return volume.row(static_cast<int>(y), static_cast<int>(z))[x >> 6] >> (x & 63);
            };
            const auto [first, end] = gather(slice + x, ny, width, bits, rows);
            for (std::size_t i = first; i < end; ++i) {
                const Lanes best = nearest(rows, i, first, end);
                std::uint16_t* out = slice + (i - 1) * width + x;
                for (std::size_t c = 0; c < kLanes; ++c) {
                    out[c] = static_cast<std::uint16_t>(best[c] + kShift);
                }
            }
        }
    }
    std::vector<std::uint32_t> squared(nx * ny * nz, 0);
    for (std::size_t y = 0; y < ny; ++y) {
        for (std::size_t x = 0; x < width; x += kLanes) {
            const auto bits = [&](std::size_t z) {
                return volume.row(static_cast<int>(y), static_cast<int>(z))[x >> 6] >> (x & 63);
            };
            const auto [first, end] =
                gather(planar.data() + y * width + x, nz, width * ny, bits, rows);
            const std::size_t columns = std::min(kLanes, nx - x);
            for (std::size_t i = first; i < end; ++i) {
                const Lanes best = nearest(rows, i, first, end);
                std::uint32_t* out = squared.data() + ((i - 1) * ny + y) * nx + x;
                for (std::size_t c = 0; c < columns; ++c) {
                    out[c] = static_cast<std::uint32_t>(best[c] + kShift);
                }
            }
        }
    }
    return squared;
}

}  // namespace ossuary
