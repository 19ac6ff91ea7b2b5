#include "engine/skeleton/block_grid.h"

#include <algorithm>
#include <utility>

namespace ossuary {
namespace {

/// Pairs of neighbouring bits to single bits: their union, the 32 results side by side.
std::uint64_t halve(std::uint64_t bits) {
    bits = (bits | bits >> 1) & 0x5555555555555555u;
    bits = (bits | bits >> 1) & 0x3333333333333333u;
    bits = (bits | bits >> 2) & 0x0f0f0f0f0f0f0f0fu;
    bits = (bits | bits >> 4) & 0x00ff00ff00ff00ffu;
    bits = (bits | bits >> 8) & 0x0000ffff0000ffffu;
    return (bits | bits >> 16) & 0x00000000ffffffffu;
}

ThinningGrid occupied_blocks(const BitVolume& solid, int edge) {
    BitVolume blocks((solid.size().array() + (edge - 1)) / edge);
    const int per_word = 64 / edge;
    for (int z = 0; z < solid.size().z(); ++z) {
        for (int y = 0; y < solid.size().y(); ++y) {
            const auto row = solid.row(y, z);
            const auto out = blocks.row(y / edge, z / edge);
            for (std::size_t w = 0; w < row.size(); ++w) {
                std::uint64_t bits = row[w];
                for (int width = 1; width < edge; width *= 2) bits = halve(bits);
                const std::size_t first = w * static_cast<std::size_t>(per_word);
                out[first / 64] |= bits << first % 64;
            }
        }
    }
    return ThinningGrid(blocks);
}

/// The offsets along one axis that a voxel at `place` of 0 to edge - 1 reaches beyond its block: a
/// set of 0, -1 (bit 0 of 3) and 1 (bit 2).
unsigned reach_of(int place, int edge) {
    return 2u | (place == 0 ? 1u : 0u) | (place == edge - 1 ? 4u : 0u);
}

/// The neighbours at all offsets of which each coordinate is in its set.
constexpr std::array<Neighborhood, 512> kProducts = [] {
    std::array<Neighborhood, 512> products{};
    for (unsigned sets = 0; sets < 512; ++sets) {
        for (int bit = 0; bit < 27; ++bit) {
            const NeighborOffset o = neighbor_offset(bit);
            const bool inside = (sets >> (o.dx + 1) & 1u) != 0 &&
                                (sets >> (3 + o.dy + 1) & 1u) != 0 &&
                                (sets >> (6 + o.dz + 1) & 1u) != 0;
            if (inside && bit != kCentreBit) products[sets] |= Neighborhood{1} << bit;
        }
    }
    return products;
}();

}  // namespace

BlockGrid::BlockGrid(const BitVolume& solid, const DistanceField& distance, int edge)
    : edge_(edge),
      occupied_(occupied_blocks(solid, edge)),
      layout_(occupied_),
      links_(layout_.count(), 0),
      squared_(layout_.count(), 0) {
    std::vector<Neighborhood> reached(layout_.count(), 0);
    for (int z = 0; z < solid.size().z(); ++z) {
        for (int y = 0; y < solid.size().y(); ++y) add_row(solid, distance, y, z, reached);
    }
    link(reached);
}

BlockGrid::BlockGrid(const BitVolume& solid, const DistanceField& distance, int edge,
                     ThinningGrid candidates)
    : edge_(edge),
      occupied_(std::move(candidates)),
      layout_(occupied_),
      links_(layout_.count(), 0),
      squared_(layout_.count(), 0) {
    std::vector<Neighborhood> reached(layout_.count(), 0);
    occupied_.for_each([&](VoxelIndex block) {
        const Neighborhood beyond = add_block(solid, distance, block);
        if (beyond == 0) occupied_.reset(block);
        reached[layout_.place(block)] = beyond;
    });
    link(reached);
}

void BlockGrid::add_row(const BitVolume& solid, const DistanceField& distance, int y, int z,
                        std::vector<Neighborhood>& reached) {
    // Edges are powers of two: shifts and masks in place of divisions.
    const int shift = std::countr_zero(static_cast<unsigned>(edge_));
    const int inside = edge_ - 1;
    const unsigned sides = reach_of(y & inside, edge_) << 3 | reach_of(z & inside, edge_) << 6;
    const std::uint32_t* depths = distance.squared_row(y, z);
    const VoxelIndex row = shape().index(0, y >> shift, z >> shift);
    for_each_run(solid.row(y, z), solid.size().x(), false, [&](int begin, int end) {
        std::size_t block = layout_.place(row + static_cast<VoxelIndex>(begin >> shift));
        for (int x = begin; x < end; ++block) {
            const int block_end = std::min(end, ((x >> shift) + 1) << shift);
            const unsigned along =
                reach_of(x & inside, edge_) | reach_of((block_end - 1) & inside, edge_);
            reached[block] |= kProducts[sides | along];
            std::uint32_t deepest = squared_[block];
            for (; x < block_end; ++x) deepest = std::max(deepest, depths[x]);
            squared_[block] = deepest;
        }
    });
}

Neighborhood BlockGrid::add_block(const BitVolume& solid, const DistanceField& distance,
                                  VoxelIndex block) {
    const Vec3i first = shape().position(block) * edge_;
    const int last = edge_ - 1;
    Neighborhood beyond = 0;
    std::uint32_t deepest = 0;
    for (int k = 0; k < edge_ && first.z() + k < solid.size().z(); ++k) {
        for (int j = 0; j < edge_ && first.y() + j < solid.size().y(); ++j) {
            const int y = first.y() + j;
            const int z = first.z() + k;
            std::uint64_t bits = bits_of_row(solid, first.x(), y, z);
            if (bits == 0) continue;
            const unsigned along = 2u | static_cast<unsigned>(bits & 1u) |
                                   static_cast<unsigned>(bits >> last & 1u) << 2;
            beyond |= kProducts[along | reach_of(j, edge_) << 3 | reach_of(k, edge_) << 6];
            const std::uint32_t* depths = distance.squared_row(y, z) + first.x();
            for (; bits != 0; bits &= bits - 1) {
                deepest = std::max(deepest, depths[std::countr_zero(bits)]);
            }
        }
    }
    squared_[layout_.place(block)] = deepest;
    return beyond | (deepest > 0 ? kCentre : 0);
}

void BlockGrid::link(const std::vector<Neighborhood>& reached) {
    const auto steps = shape().neighbor_steps();
    occupied_.for_each([&](VoxelIndex block) {
        const std::size_t place = layout_.place(block);
        Neighborhood linked = 0;
        for_each_bit(occupied_.neighborhood(block) & reached[place] & k26Neighbors, [&](int bit) {
            const VoxelIndex other = moved(block, steps[static_cast<std::size_t>(bit)]);
            linked |= (reached[layout_.place(other)] >> opposite_bit(bit) & 1u) << bit;
        });
        links_[place] = linked;
    });
}

}  // namespace ossuary
