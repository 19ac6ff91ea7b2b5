#include "engine/voxel/border.h"

namespace ossuary::voxel {

BitVolume border(const BitVolume& volume) {
    const Vec3i size = volume.size();
    const std::vector<std::uint64_t> empty(volume.words_per_row(), 0);
    const auto row = [&](int y, int z) {
        const bool inside = y >= 0 && z >= 0 && y < size.y() && z < size.z();
        return inside ? volume.row(y, z).data() : empty.data();
    };
    BitVolume result(size);
    for (int z = 0; z < size.z(); ++z) {
        for (int y = 0; y < size.y(); ++y) {
            const std::uint64_t* here = row(y, z);
            const std::uint64_t* rows[] = {row(y - 1, z), row(y + 1, z), row(y, z - 1),
                                           row(y, z + 1)};
            const auto out = result.row(y, z);
            for (std::size_t w = 0; w < out.size(); ++w) {
                if (here[w] == 0) continue;
                const std::uint64_t before = (here[w] << 1) | (w > 0 ? here[w - 1] >> 63 : 0);
                const std::uint64_t after =
                    (here[w] >> 1) | (w + 1 < out.size() ? here[w + 1] << 63 : 0);
                const std::uint64_t inner =
                    before & after & rows[0][w] & rows[1][w] & rows[2][w] & rows[3][w];
                out[w] = here[w] & ~inner;
            }
        }
    }
    return result;
}

std::vector<Vec3i> border_points(const BitVolume& volume) {
    std::vector<Vec3i> points;
    for_each_voxel(border(volume), [&](const Vec3i& v) { points.push_back(v); });
    return points;
}

}  // namespace ossuary::voxel
