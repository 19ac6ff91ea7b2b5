#include "engine/voxel/betti.h"

#include <bit>
#include <vector>

#include "engine/voxel/count_components.h"
#include "engine/voxel/inner_runs.h"

namespace ossuary::voxel {
namespace {

/// The number of stretches of set bits that begin in a word. @param carry  the bit before it
std::int64_t stretches(std::uint64_t word, std::uint64_t& carry) {
    const std::uint64_t begins = word & ~((word << 1) | carry);
    carry = word >> 63;
    return std::popcount(begins);
}

}  // namespace

// 64 cells at a time: a cell of the complex is there when any cube around it is set, so the cells
// of one kind along a row are the OR of up to four rows. Along x a stretch of n cells has n + 1
// points at its ends and between: one more. (A table over the 256 octants needs a look-up for every
// lattice point.)
std::int64_t euler_characteristic(const BitVolume& volume) {
    const Vec3i size = volume.size();
    const std::size_t words = volume.words_per_row();
    const std::vector<std::uint64_t> empty(words, 0);
    const auto row = [&](int y, int z) {
        const bool inside = y >= 0 && z >= 0 && y < size.y() && z < size.z();
        return inside ? volume.row(y, z).data() : empty.data();
    };
    std::int64_t euler = 0;
    for (int z = 0; z <= size.z(); ++z) {
        for (int y = 0; y <= size.y(); ++y) {
            const std::uint64_t* here = row(y, z);
            const std::uint64_t* below_y = row(y - 1, z);
            const std::uint64_t* below_z = row(y, z - 1);
            const std::uint64_t* below_both = row(y - 1, z - 1);
            std::uint64_t carry_all = 0, carry_y = 0, carry_z = 0, carry_here = 0;
            for (std::size_t w = 0; w < words; ++w) {
                const std::uint64_t a = here[w];
                const std::uint64_t ab = a | below_y[w];
                const std::uint64_t ac = a | below_z[w];
                const std::uint64_t all = ab | ac | below_both[w];
                if (all == 0) {
                    carry_all = carry_y = carry_z = carry_here = 0;
                    continue;
                }
                euler += stretches(all, carry_all);  // vertices, edges along x
                euler -= stretches(ac, carry_y);     // edges along y, faces xy
                euler -= stretches(ab, carry_z);     // edges along z, faces xz
                euler += stretches(a, carry_here);   // faces yz, cubes
            }
        }
    }
    return euler;
}

BettiNumbers betti_numbers(const BitVolume& volume) {
    BettiNumbers betti;
    betti.components = static_cast<int>(count_components(volume));
    betti.cavities = static_cast<int>(count_cavities(volume));
    betti.tunnels =
        static_cast<int>(betti.components + betti.cavities - euler_characteristic(volume));
    return betti;
}

}  // namespace ossuary::voxel
