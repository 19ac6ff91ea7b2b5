#include "engine/voxel/distance_envelope.h"

#include <algorithm>

#include "engine/voxel/distance_columns.h"

namespace ossuary::voxel {
namespace {

/// Columns gathered at once: one cache line of the result, so that no step along the stride misses.
constexpr std::size_t kTile = DistanceField::kGroup;

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
void transform_rows(const BitVolume& volume, DistanceField& field) {
    for (int z = 0; z < volume.size().z(); ++z) {
        for (int y = 0; y < volume.size().y(); ++y) {
            std::uint32_t* out = field.values().data() + field.row(y, z).start;
            for_each_run(volume.row(y, z), volume.size().x(), false, [&](int begin, int end) {
                for (int x = begin; x < end; ++x) {
                    const auto d = static_cast<std::uint32_t>(std::min(x - begin + 1, end - x));
                    out[x] = d * d;
                }
            });
        }
    }
}

/// Transforms each of the columns of voxels in a column of groups.
/// @param tile  room for the column
void transform_column(const GroupColumn& groups, std::uint32_t* values, Envelope& envelope,
                      std::vector<std::uint32_t>& tile) {
    const std::size_t length = groups.length;
    for (std::size_t i = 0; i < length; ++i) {
        const std::uint32_t* group = values + groups.places[i];
        for (std::size_t c = 0; c < kTile; ++c) tile[c * length + i] = group[c];
    }
    for (std::size_t c = 0; c < kTile; ++c) {
        std::uint32_t* column = tile.data() + c * length;
        for (std::size_t i = 0; i < length;) {
            while (i < length && column[i] == 0) ++i;
            const std::size_t begin = i;
            while (i < length && column[i] != 0) ++i;
            if (begin < i) {
                envelope.transform(column, static_cast<std::int32_t>(begin),
                                   static_cast<std::int32_t>(i));
            }
        }
    }
    for (std::size_t i = 0; i < length; ++i) {
        std::uint32_t* group = values + groups.places[i];
        for (std::size_t c = 0; c < kTile; ++c) group[c] = tile[c * length + i];
    }
}

}  // namespace

DistanceField distances_by_envelope(const BitVolume& volume, const std::stop_token& stop) {
    DistanceField field(volume);
    if (volume.voxel_count() == 0) return field;
    transform_rows(volume, field);
    GroupColumns columns(volume, field);
    const auto longest = static_cast<std::size_t>(volume.size().tail<2>().maxCoeff());
    Envelope envelope(longest);
    std::vector<std::uint32_t> tile(kTile * longest);
    for (const int axis : {1, 2}) {
        columns.for_each(axis, stop, [&](const GroupColumn& column) {
            transform_column(column, field.values().data(), envelope, tile);
        });
    }
    return field;
}

}  // namespace ossuary::voxel
