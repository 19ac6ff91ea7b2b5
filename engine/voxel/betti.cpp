#include "engine/voxel/betti.h"

#include <vector>

#include "engine/voxel/components.h"
#include "engine/voxel/inner_runs.h"

namespace ossuary {
namespace {

/// The number of ones, without the library call that std::popcount is on a machine-independent
/// build.
std::int64_t ones(std::uint64_t word) {
    word -= (word >> 1) & 0x5555555555555555u;
    word = (word & 0x3333333333333333u) + ((word >> 2) & 0x3333333333333333u);
    word = (word + (word >> 4)) & 0x0f0f0f0f0f0f0f0fu;
    return static_cast<std::int64_t>((word * 0x0101010101010101u) >> 56);
}

}  // namespace

// 64 cells at a time: a cell of the complex is there when any cube around it is set, so the cells
// of one kind along a row are the OR of up to four rows, and of these shifted by one where the cell
// is a point along x. (A table over the 256 octants needs a look-up for every lattice point.)
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
            std::uint64_t carry_point = 0, carry_edge_y = 0, carry_edge_z = 0, carry_face = 0;
            for (std::size_t w = 0; w < words; ++w) {
                const std::uint64_t a = here[w];
                const std::uint64_t ab = a | below_y[w];
                const std::uint64_t ac = a | below_z[w];
                const std::uint64_t all = ab | ac | below_both[w];
                if (all == 0 && carry_point == 0) continue;
                const auto at_points = [](std::uint64_t cells, std::uint64_t& carry) {
                    const std::uint64_t shifted = cells | (cells << 1) | carry;
                    carry = cells >> 63;
                    return shifted;
                };
                euler += ones(at_points(all, carry_point)) - ones(all);  // vertices, edges along x
                euler -= ones(at_points(ac, carry_edge_y)) - ones(ac);   // edges along y, faces xy
                euler -= ones(at_points(ab, carry_edge_z)) - ones(ab);   // edges along z, faces xz
                euler += ones(at_points(a, carry_face)) - ones(a);       // faces yz, cubes
            }
            // Points at the far end of a row that fills its last word to the last bit.
            euler +=
                static_cast<std::int64_t>(carry_point) - static_cast<std::int64_t>(carry_edge_y) -
                static_cast<std::int64_t>(carry_edge_z) + static_cast<std::int64_t>(carry_face);
        }
    }
    return euler;
}

BettiNumbers betti_numbers(const BitVolume& volume) {
    BettiNumbers betti;
    betti.components = static_cast<int>(label_components(volume, Connectivity::kVertices).count());
    betti.cavities = static_cast<int>(count_cavities(volume));
    betti.tunnels =
        static_cast<int>(betti.components + betti.cavities - euler_characteristic(volume));
    return betti;
}

}  // namespace ossuary
