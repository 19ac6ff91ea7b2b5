#include "engine/voxel/distance_scan.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "engine/voxel/distance_columns.h"

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace ossuary::voxel {
namespace {

constexpr std::size_t kLanes = DistanceField::kGroup;

/// Values less 2^15: the basic vector instructions find the smaller of two 16-bit integers only
/// with a sign.
using Lanes [[gnu::vector_size(2 * kLanes)]] = std::int16_t;
constexpr int kShift = 1 << 15;

/// So many steps are taken between looks at whether there is need for more.
constexpr std::size_t kStride = 2;

/// Whether some lane is above a limit. (Finding the largest takes longer than ten steps.)
[[gnu::always_inline]] inline bool any_above(const Lanes& lanes, std::size_t limit) {
    const Lanes above = lanes > static_cast<std::int16_t>(static_cast<int>(limit) - kShift);
#ifdef __SSE2__
    using Half [[gnu::vector_size(kLanes)]] = std::int16_t;
    const Half low = __builtin_shufflevector(above, above, 0, 1, 2, 3, 4, 5, 6, 7);
    const Half high = __builtin_shufflevector(above, above, 8, 9, 10, 11, 12, 13, 14, 15);
    return _mm_movemask_epi8(reinterpret_cast<__m128i>(low | high)) != 0;
#else
    std::array<std::uint64_t, sizeof(Lanes) / 8> words;
    std::memcpy(words.data(), &above, sizeof above);
    std::uint64_t any = 0;
    for (const std::uint64_t word : words) any |= word;
    return any != 0;
#endif
}

/// Lowers `best`, which is *row, to the nearest. All rows of background that a column has beyond
/// its ends have to be seen as one: the search ends before kStride rows of it.
[[gnu::always_inline]] inline void find_nearest(const Lanes* row, Lanes& best) {
    for (std::size_t k = 1; any_above(best, k * k);) {
        for (std::size_t step = 0; step < kStride; ++step, ++k) {
            const Lanes& above = *(row - k);
            const Lanes& below = row[k];
            const Lanes nearer = above < below ? above : below;
            const Lanes there = nearer + static_cast<std::int16_t>(k * k);
            best = there < best ? there : best;
        }
    }
}

/// Stands for all that is as far or farther: what is nearer comes out the same.
constexpr std::size_t kFar = (kFarthestScan + 1) * (kFarthestScan + 1);

/// Transforms a column: groups of `in` at its places to those of `out`, which may be the same.
/// @param rows  room for the column and kStride rows at either end
/// @return whether some voxel is kFar
template <typename Out>
[[gnu::always_inline]] inline bool scan_column(const GroupColumn& column, const std::uint16_t* in,
                                               Out* out, Lanes* rows) {
    constexpr auto kBackground = static_cast<std::int16_t>(-kShift);
    for (std::size_t i = 0; i < kStride; ++i) {
        rows[i] = Lanes{} + kBackground;
        rows[kStride + column.length + i] = Lanes{} + kBackground;
    }
    rows += kStride;
    for (std::size_t i = 0; i < column.length; ++i) {
        std::memcpy(&rows[i], in + column.places[i], sizeof(Lanes));
        rows[i] ^= kBackground;
    }
    Lanes farthest = Lanes{} + kBackground;
    for (std::size_t i = 0; i < column.length; ++i) {
        Lanes best = rows[i];
        find_nearest(rows + i, best);
        farthest = farthest > best ? farthest : best;
        best ^= kBackground;
        std::array<std::uint16_t, kLanes> values;
        std::memcpy(values.data(), &best, sizeof best);
        Out* group = out + column.places[i];
        for (std::size_t c = 0; c < kLanes; ++c) group[c] = values[c];
    }
    return any_above(farthest, kFar - 1);
}

using ScanAlongY = void (*)(const GroupColumn&, std::uint16_t*, Lanes*);
using ScanAlongZ = bool (*)(const GroupColumn&, const std::uint16_t*, std::uint32_t*, Lanes*);

void along_y(const GroupColumn& column, std::uint16_t* planar, Lanes* rows) {
    scan_column(column, planar, planar, rows);
}
bool along_z(const GroupColumn& column, const std::uint16_t* planar, std::uint32_t* squared,
             Lanes* rows) {
    return scan_column(column, planar, squared, rows);
}

#if defined(__x86_64__) && defined(__GNUC__)
// The same for machines that have vectors of 32 bytes: half the time.
[[gnu::target("avx2")]] void along_y_wide(const GroupColumn& column, std::uint16_t* planar,
                                          Lanes* rows) {
    scan_column(column, planar, planar, rows);
}
[[gnu::target("avx2")]] bool along_z_wide(const GroupColumn& column, const std::uint16_t* planar,
                                          std::uint32_t* squared, Lanes* rows) {
    return scan_column(column, planar, squared, rows);
}
ScanAlongY scan_along_y() { return __builtin_cpu_supports("avx2") ? along_y_wide : along_y; }
ScanAlongZ scan_along_z() { return __builtin_cpu_supports("avx2") ? along_z_wide : along_z; }
#else
ScanAlongY scan_along_y() { return along_y; }
ScanAlongZ scan_along_z() { return along_z; }
#endif

/// Along x the distance to the nearer end of the run is the whole story.
void scan_rows(const BitVolume& volume, const DistanceField& field,
               std::vector<std::uint16_t>& squared) {
    std::array<std::uint16_t, kFarthestScan> rising, falling;
    for (std::size_t i = 0; i < rising.size(); ++i) {
        rising[i] = static_cast<std::uint16_t>((i + 1) * (i + 1));
        falling[rising.size() - 1 - i] = rising[i];
    }
    for (int z = 0; z < volume.size().z(); ++z) {
        for (int y = 0; y < volume.size().y(); ++y) {
            const DistanceField::Row& stored = field.row(y, z);
            if (stored.begin == stored.end) continue;
            std::uint16_t* out = squared.data() + stored.start;
            for_each_run(volume.row(y, z), volume.size().x(), false, [&](int begin, int end) {
                const auto length = static_cast<std::size_t>(end - begin);
                const std::size_t up = std::min((length + 1) / 2, rising.size());
                const std::size_t down = std::min(length / 2, falling.size());
                std::memcpy(out + begin, rising.data(), up * sizeof *out);
                std::fill(out + begin + up, out + end - down, static_cast<std::uint16_t>(kFar));
                std::memcpy(out + end - down, falling.data() + falling.size() - down,
                            down * sizeof *out);
            });
        }
    }
}

}  // namespace

std::optional<DistanceField> distances_by_scan(const BitVolume& volume,
                                               const std::stop_token& stop) {
    DistanceField field(volume);
    if (volume.voxel_count() == 0) return field;
    GroupColumns columns(volume, field);
    std::vector<std::uint16_t> planar(field.values().size(), 0);
    scan_rows(volume, field, planar);
    const auto longest = static_cast<std::size_t>(volume.size().tail<2>().maxCoeff());
    struct alignas(sizeof(Lanes)) Row {
        Lanes lanes;
    };
    std::vector<Row> rows(longest + 2 * kStride);
    const ScanAlongY scan_y = scan_along_y();
    columns.for_each(1, stop, [&](const GroupColumn& column) {
        scan_y(column, planar.data(), &rows.front().lanes);
    });
    const ScanAlongZ scan_z = scan_along_z();
    bool far = false;
    columns.for_each(2, stop, [&](const GroupColumn& column) {
        far |= scan_z(column, planar.data(), field.values().data(), &rows.front().lanes);
    });
    if (far) return std::nullopt;
    return field;
}

}  // namespace ossuary::voxel
