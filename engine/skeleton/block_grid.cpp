#include "engine/skeleton/block_grid.h"

#include <algorithm>
#include <utility>

namespace ossuary::skeleton {
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

/// Calls `visit(row, j, k)` for the voxel rows of a row of blocks that hold something; j and k are
/// their places in the blocks along y and z.
template <typename Visit>
void for_each_row_of(const voxel::BitVolume& solid, int edge, int block_y, int block_z,
                     Visit&& visit) {
    const int rows_y = std::min(edge, solid.size().y() - block_y * edge);
    const int rows_z = std::min(edge, solid.size().z() - block_z * edge);
    for (int k = 0; k < rows_z; ++k) {
        for (int j = 0; j < rows_y; ++j) {
            const auto row = solid.row(block_y * edge + j, block_z * edge + k);
            std::uint64_t any = 0;
            for (const std::uint64_t word : row) any |= word;
            if (any != 0) visit(row, j, k);
        }
    }
}

ThinningGrid occupied_blocks(const voxel::BitVolume& solid, int edge) {
    voxel::BitVolume blocks((solid.size().array() + (edge - 1)) / edge);
    const auto per_word = static_cast<std::size_t>(64 / edge);
    std::vector<std::uint64_t> all(solid.words_per_row());
    for (int z = 0; z < blocks.size().z(); ++z) {
        for (int y = 0; y < blocks.size().y(); ++y) {
            std::fill(all.begin(), all.end(), 0);
            for_each_row_of(solid, edge, y, z, [&](auto row, int, int) {
                for (std::size_t w = 0; w < all.size(); ++w) all[w] |= row[w];
            });
            const auto out = blocks.row(y, z);
            for (std::size_t w = 0; w < all.size(); ++w) {
                std::uint64_t bits = all[w];
                if (bits == 0) continue;
                for (int width = 1; width < edge; width *= 2) bits = halve(bits);
                out[w * per_word / 64] |= bits << w * per_word % 64;
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

/// The same for a row of voxels within a block: bits 0, 1 and 2 for -1, 0 and 1.
unsigned reach_along(std::uint64_t bits, int edge) {
    return (bits != 0 ? 2u : 0u) | static_cast<unsigned>(bits & 1u) |
           static_cast<unsigned>(bits >> (edge - 1) & 1u) << 2;
}

/// What the voxels of a block reach, gathered row by row.
class Reach {
public:
    /// The voxels of all rows that lie at a side, for each of the nine sides along y and z: what
    /// a block reaches there are three bits in turn of its neighbourhood.
    Reach(int edge, std::size_t words) : edge_(edge), words_(words), sides_(9 * words) {}

    void clear() { std::fill(sides_.begin(), sides_.end(), 0); }
    /// @param j, k  places of the row in the blocks along y and z
    void add(std::span<const std::uint64_t> row, int j, int k) {
        const unsigned along_y = reach_of(j, edge_);
        const unsigned along_z = reach_of(k, edge_);
        for (std::size_t side = 0; side < 9; ++side) {
            if ((along_y >> side % 3 & along_z >> side / 3 & 1u) == 0) continue;
            for (std::size_t w = 0; w < words_; ++w) sides_[side * words_ + w] |= row[w];
        }
    }
    /// Of the block whose first voxel is `x`, with the centre when it has any.
    [[nodiscard]] Neighborhood of(std::size_t x) const {
        const std::uint64_t mask = (std::uint64_t{1} << edge_) - 1;
        Neighborhood reached = 0;
        for (std::size_t side = 0; side < 9; ++side) {
            const std::uint64_t bits = sides_[side * words_ + x / 64] >> x % 64 & mask;
            reached |= reach_along(bits, edge_) << 3 * side;
        }
        return reached;
    }

private:
    int edge_;
    std::size_t words_;
    std::vector<std::uint64_t> sides_;
};

/// Of nine rows of three neighbours the bits that stand for the centre, in the neighbours' view.
constexpr std::array<std::array<Neighborhood, 4>, 9> kCentreOfNeighbors = [] {
    std::array<std::array<Neighborhood, 4>, 9> bits{};
    for (std::size_t bit = 0; bit < 27; ++bit) {
        bits[bit / 3][bit % 3] = Neighborhood{1} << opposite_bit(static_cast<int>(bit));
    }
    return bits;
}();

}  // namespace

BlockGrid::BlockGrid(const voxel::BitVolume& solid, const voxel::DistanceField& distance, int edge)
    : edge_(edge),
      occupied_(occupied_blocks(solid, edge)),
      layout_(occupied_),
      links_(layout_.count(), 0),
      squared_(layout_.count(), 0) {
    std::vector<Neighborhood> reached(layout_.count(), 0);
    Reach reach(edge, solid.words_per_row());
    std::vector<std::uint32_t> deepest;  // by x, of all rows of a row of blocks
    VoxelIndex row_end = 0;
    occupied_.for_each([&](VoxelIndex block) {
        const Vec3i position = shape().position(block);
        if (block >= row_end) {
            row_end = block - static_cast<VoxelIndex>(position.x()) + shape().row();
            reach.clear();
            deepest.assign(static_cast<std::size_t>(shape().size().x() * edge), 0);
            for_each_row_of(solid, edge, position.y(), position.z(), [&](auto row, int j, int k) {
                reach.add(row, j, k);
                const int y = position.y() * edge + j;
                const int z = position.z() * edge + k;
                const voxel::DistanceField::Row& stored = distance.row(y, z);
                const std::uint32_t* depths = distance.squared_row(y, z);
                const int end = std::min(stored.end, solid.size().x());
                for (int x = stored.begin; x < end; ++x) {
                    std::uint32_t& most = deepest[static_cast<std::size_t>(x)];
                    most = std::max(most, depths[x]);
                }
            });
        }
        const std::size_t first = static_cast<std::size_t>(position.x() * edge);
        const std::size_t place = layout_.place(block);
        reached[place] = reach.of(first);
        for (std::size_t x = first; x < first + static_cast<std::size_t>(edge); ++x) {
            squared_[place] = std::max(squared_[place], deepest[x]);
        }
    });
    link(reached);
}

BlockGrid::BlockGrid(const voxel::BitVolume& solid, const voxel::DistanceField& distance, int edge,
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

Neighborhood BlockGrid::add_block(const voxel::BitVolume& solid,
                                  const voxel::DistanceField& distance, VoxelIndex block) {
    const Vec3i first = shape().position(block) * edge_;
    Neighborhood reached = 0;
    std::uint32_t deepest = 0;
    for (int k = 0; k < edge_ && first.z() + k < solid.size().z(); ++k) {
        for (int j = 0; j < edge_ && first.y() + j < solid.size().y(); ++j) {
            const int y = first.y() + j;
            const int z = first.z() + k;
            std::uint64_t bits = bits_of_row(solid, first.x(), y, z);
            if (bits == 0) continue;
            const Neighborhood along = reach_along(bits, edge_);
            const unsigned sides = reach_of(j, edge_) << 3 | reach_of(k, edge_);
            for (unsigned side = 0; side < 9; ++side) {
                if ((sides >> (3 + side % 3) & sides >> side / 3 & 1u) != 0) {
                    reached |= along << 3 * side;
                }
            }
            const std::uint32_t* depths = distance.squared_row(y, z) + first.x();
            for (; bits != 0; bits &= bits - 1) {
                deepest = std::max(deepest, depths[std::countr_zero(bits)]);
            }
        }
    }
    squared_[layout_.place(block)] = deepest;
    return reached;
}

void BlockGrid::link(const std::vector<Neighborhood>& reached) {
    occupied_.for_each([&](VoxelIndex block) {
        const std::uint32_t row = layout_.row_of(block);
        const std::uint32_t offset = layout_.offset_in_row(block, row);
        Neighborhood back = 0;
        for (std::size_t r = 0; r < 9; ++r) {
            const std::size_t first =
                layout_.place(offset, row + static_cast<std::uint32_t>(layout_.row_steps()[r])) - 1;
            for (std::size_t i = 0; i < 3; ++i) {
                const bool reaches = (reached[first + i] & kCentreOfNeighbors[r][i]) != 0;
                back |= static_cast<Neighborhood>(reaches) << (3 * r + i);
            }
        }
        const std::size_t place = layout_.place(offset, row);
        links_[place] = reached[place] & back & k26Neighbors;
    });
}

}  // namespace ossuary::skeleton
