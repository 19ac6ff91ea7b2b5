#include "engine/voxel/distance_envelope.h"

#include <algorithm>

namespace ossuary {
namespace {

/// Columns gathered at once: one cache line of the result, so that no step along the stride misses.
constexpr std::size_t kTile = 16;

/// The lower envelope of the parabolas f(q) + (x - q)² over one column. 32 bits hold all values for
/// sides up to 2^15, and divide in a third of the time of 64.
class Envelope {
public:
    explicit Envelope(std::size_t length) : parabolas_(length + 2) {}

    /// Transforms the run [begin, end) of set voxels in place. The background voxels that bound it
    /// (begin - 1 and end) have height 0, so that nothing beyond them can be nearer.
    void transform(std::uint32_t* column, std::int32_t begin, std::int32_t end) {
        Parabola* last = parabolas_.data();
        *last = {begin - 1, (begin - 1) * (begin - 1), begin};
        for (std::int32_t q = begin; q <= end; ++q) {
            const std::int32_t height = q < end ? static_cast<std::int32_t>(column[q]) : 0;
            const std::int32_t level = height + q * q;
            std::int32_t from = first_below(q, level, *last);
            while (last != parabolas_.data() && from <= last->from) {
                from = first_below(q, level, *--last);
            }
            if (from >= end) continue;
            if (from > last->from) ++last;
            *last = {q, level, std::max(from, begin)};
        }
        // From here on `from` of the one after is where a parabola ends.
        last[1].from = end;
        const Parabola* parabola = parabolas_.data();
        for (std::int32_t x = begin; x < end; ++parabola) {
            const std::int32_t apex = parabola->apex;
            const std::int32_t height = parabola->level - apex * apex;
            for (const std::int32_t to = parabola[1].from; x < to; ++x) {
                column[x] = static_cast<std::uint32_t>((x - apex) * (x - apex) + height);
            }
        }
    }

private:
    struct Parabola {
        std::int32_t apex;
        std::int32_t level;  ///< height + apex²
        std::int32_t from;   ///< first x where this one is the lowest
    };

    /// The first x >= 0 at which the parabola at q is below an earlier one.
    static std::int32_t first_below(std::int32_t q, std::int32_t level, const Parabola& other) {
        const std::int32_t rise = level - other.level;
        return rise < 0 ? 0 : rise / (2 * (q - other.apex)) + 1;
    }

    std::vector<Parabola> parabolas_;
};

/// Along x the distance to the nearer end of the run is the whole story.
void transform_rows(const BitVolume& volume, std::vector<std::uint32_t>& squared) {
    const Vec3i size = volume.size();
    std::size_t row_start = 0;
    for (int z = 0; z < size.z(); ++z) {
        for (int y = 0; y < size.y(); ++y, row_start += static_cast<std::size_t>(size.x())) {
            for_each_run(volume.row(y, z), size.x(), false, [&](int begin, int end) {
                std::uint32_t* out = squared.data() + row_start;
                for (int x = begin; x < end; ++x) {
                    const auto d = static_cast<std::uint32_t>(std::min(x - begin + 1, end - x));
                    out[x] = d * d;
                }
            });
        }
    }
}

/// Transforms `length` rows of `width` values, `stride` apart, along the stride.
void transform_columns(std::uint32_t* values, std::size_t length, std::size_t stride,
                       std::size_t width, Envelope& envelope, std::vector<std::uint32_t>& tile) {
    for (std::size_t x0 = 0; x0 < width; x0 += kTile) {
        const std::size_t columns = std::min(kTile, width - x0);
        std::size_t first = length, last = 0;
        for (std::size_t i = 0; i < length; ++i) {
            const std::uint32_t* row = values + i * stride + x0;
            std::uint32_t any = 0;
            for (std::size_t c = 0; c < columns; ++c) any |= row[c];
            if (any == 0) continue;
            first = std::min(first, i);
            last = i + 1;
        }
        if (first >= last) continue;
        for (std::size_t i = first; i < last; ++i) {
            const std::uint32_t* row = values + i * stride + x0;
            for (std::size_t c = 0; c < columns; ++c) tile[c * length + i] = row[c];
        }
        for (std::size_t c = 0; c < columns; ++c) {
            std::uint32_t* column = tile.data() + c * length;
            for (std::size_t i = first; i < last;) {
                while (i < last && column[i] == 0) ++i;
                const std::size_t begin = i;
                while (i < last && column[i] != 0) ++i;
                if (begin < i) {
                    envelope.transform(column, static_cast<std::int32_t>(begin),
                                       static_cast<std::int32_t>(i));
                }
            }
        }
        for (std::size_t i = first; i < last; ++i) {
            std::uint32_t* row = values + i * stride + x0;
            for (std::size_t c = 0; c < columns; ++c) row[c] = tile[c * length + i];
        }
    }
}

}  // namespace

std::vector<std::uint32_t> distances_by_envelope(const BitVolume& volume) {
    const auto nx = static_cast<std::size_t>(volume.size().x());
    const auto ny = static_cast<std::size_t>(volume.size().y());
    const auto nz = static_cast<std::size_t>(volume.size().z());
    std::vector<std::uint32_t> squared(volume.voxel_count(), 0);
    transform_rows(volume, squared);
    const std::size_t longest = std::max(ny, nz);
    Envelope envelope(longest);
    std::vector<std::uint32_t> tile(kTile * longest);
    for (std::size_t z = 0; z < nz; ++z) {
        transform_columns(squared.data() + z * ny * nx, ny, nx, nx, envelope, tile);
    }
    for (std::size_t y = 0; y < ny; ++y) {
        transform_columns(squared.data() + y * nx, nz, nx * ny, nx, envelope, tile);
    }
    return squared;
}

}  // namespace ossuary
