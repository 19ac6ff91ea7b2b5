#include "engine/skeleton/block_grid.h"

#include <algorithm>

namespace ossuary {
namespace {

ThinningGrid occupied_blocks(const BitVolume& solid, int edge) {
    if (edge == 1) return ThinningGrid(solid);
    const Vec3i size = (solid.size().array() + (edge - 1)) / edge;
    BitVolume blocks(size);
    for (int z = 0; z < solid.size().z(); ++z) {
        for (int y = 0; y < solid.size().y(); ++y) {
            const auto row = solid.row(y, z);
            const auto out = blocks.row(y / 2, z / 2);
            for (std::size_t w = 0; w < row.size(); ++w) {
                // Pairs of bits to single bits: or the pair, then close the gaps.
                std::uint64_t bits = (row[w] | row[w] >> 1) & 0x5555555555555555u;
                bits = (bits | bits >> 1) & 0x3333333333333333u;
                bits = (bits | bits >> 2) & 0x0f0f0f0f0f0f0f0fu;
                bits = (bits | bits >> 4) & 0x00ff00ff00ff00ffu;
                bits = (bits | bits >> 8) & 0x0000ffff0000ffffu;
                bits = (bits | bits >> 16) & 0x00000000ffffffffu;
                out[w / 2] |= bits << (w % 2 * 32);
            }
        }
    }
    return ThinningGrid(blocks);
}

/// For each of the 256 fillings of a 2x2x2 block the neighbours whose side it reaches: bit
/// dz * 4 + dy * 2 + dx of a filling is the voxel at that place.
constexpr std::array<Neighborhood, 256> kReached = [] {
    std::array<Neighborhood, 256> reached{};
    const auto on_side = [](int place, int offset) {
        return offset == 0 || (offset > 0) == (place == 1);
    };
    for (std::size_t filling = 0; filling < 256; ++filling) {
        for (int voxel = 0; voxel < 8; ++voxel) {
            if ((filling >> voxel & 1u) == 0) continue;
            for (int bit = 0; bit < 27; ++bit) {
                const NeighborOffset o = neighbor_offset(bit);
                if (bit != kCentreBit && on_side(voxel & 1, o.dx) &&
                    on_side(voxel >> 1 & 1, o.dy) && on_side(voxel >> 2, o.dz)) {
                    reached[filling] |= Neighborhood{1} << bit;
                }
            }
        }
    }
    return reached;
}();

}  // namespace

BlockGrid::BlockGrid(const BitVolume& solid, const DistanceField& distance, int edge)
    : edge_(edge),
      occupied_(occupied_blocks(solid, edge)),
      links_(occupied_, 0),
      squared_(occupied_, 0) {
    VoxelMap<Neighborhood> reached(occupied_, k26Neighbors);
    occupied_.for_each([&](VoxelIndex block) {
        std::size_t filling = 0;
        std::uint32_t deepest = 0;
        for_each_voxel_of(solid, block, [&](const Vec3i& v) {
            filling |= std::size_t{1} << ((v.z() & 1) * 4 + (v.y() & 1) * 2 + (v.x() & 1));
            deepest = std::max(deepest, distance.squared(v));
        });
        squared_[block] = deepest;
        if (edge_ == 2) reached[block] = kReached[filling];
    });
    const auto steps = shape().neighbor_steps();
    occupied_.for_each([&](VoxelIndex block) {
        Neighborhood linked = 0;
        for_each_bit(occupied_.neighborhood(block) & reached[block], [&](int bit) {
            const VoxelIndex other = moved(block, steps[static_cast<std::size_t>(bit)]);
            linked |= (reached[other] >> opposite_bit(bit) & 1u) << bit;
        });
        links_[block] = linked;
    });
}

}  // namespace ossuary
