#include "engine/skeleton/corridor.h"

#include <algorithm>
#include <bit>
#include <cassert>

namespace ossuary::skeleton {
namespace {

class Corridor {
public:
    Corridor(const BlockGrid& blocks, const voxel::BitVolume& solid,
             const voxel::DistanceField& distance)
        : blocks_(blocks), solid_(solid), distance_(distance), voxels_(PaddedShape(solid.size())) {}

    /// @param least  squared depth of what is taken beside the block
    void add(VoxelIndex block, std::uint32_t least) {
        const Vec3i first = blocks_.shape().position(block) * blocks_.edge();
        const Vec3i last = first.array() + (blocks_.edge() - 1);
        const Vec3i begin = (first.array() - 1).max(0);
        const Vec3i end = (last.array() + 2).min(solid_.size().array());
        const unsigned width = (1u << (end.x() - begin.x())) - 1;
        const unsigned inside = ((1u << blocks_.edge()) - 1) << (first.x() - begin.x());
        for (int z = begin.z(); z < end.z(); ++z) {
            const bool in_planes = z >= first.z() && z <= last.z();
            for (int y = begin.y(); y < end.y(); ++y) {
                const bool in_rows = in_planes && y >= first.y() && y <= last.y();
                const std::uint32_t* depths = distance_.squared_row(y, z) + begin.x();
                const VoxelIndex row = voxels_.shape().index(begin.x(), y, z);
                for (unsigned bits = row_bits(begin.x(), y, z) & width; bits != 0;
                     bits &= bits - 1) {
                    const auto i = static_cast<unsigned>(std::countr_zero(bits));
                    const bool in_block = in_rows && (inside >> i & 1u) != 0;
                    if (in_block || depths[i] >= least) voxels_.set(row + i);
                }
            }
        }
    }

    [[nodiscard]] ThinningGrid take() { return std::move(voxels_); }

private:
    /// From `x` on, as many as a block and its neighbours are wide.
    [[nodiscard]] unsigned row_bits(int x, int y, int z) const {
        const auto row = solid_.row(y, z);
        const auto word = static_cast<std::size_t>(x) / 64;
        const auto bit = static_cast<std::size_t>(x) % 64;
        std::uint64_t bits = row[word] >> bit;
        if (bit > 32 && word + 1 < row.size()) bits |= row[word + 1] << (64 - bit);
        return static_cast<unsigned>(bits);
    }

    const BlockGrid& blocks_;
    const voxel::BitVolume& solid_;
    const voxel::DistanceField& distance_;
    ThinningGrid voxels_;
};

/// A step costs 1 / r^2, so that ways hardly ever lead where the solid is less deep than beside.
/// (At 96 voxels .66 of the voxels that all within one voxel are, and the same costs to 1/10,000.)
/// Blocks next to thinner ones go by those.
std::uint32_t least_beside(VoxelIndex block, const ThinningGrid& tree, const BlockGrid& blocks,
                           const std::array<std::int32_t, 27>& steps) {
    std::uint32_t thinnest = blocks.squared_radius(block);
    for_each_bit(tree.neighborhood(block) & k26Neighbors, [&](int bit) {
        const VoxelIndex other = moved(block, steps[static_cast<std::size_t>(bit)]);
        thinnest = std::min(thinnest, blocks.squared_radius(other));
    });
    return thinnest - thinnest / 5;
}

}  // namespace

ThinningGrid corridor_along(const PathsInBlocks& paths, const voxel::BitVolume& solid,
                            const voxel::DistanceField& distance) {
    const BlockGrid& blocks = paths.blocks;
    const ThinningGrid& tree = paths.tips.tree;
    assert(blocks.edge() <= 2);
    Corridor corridor(blocks, solid, distance);
    const auto steps = blocks.shape().neighbor_steps();
    tree.for_each(
        [&](VoxelIndex block) { corridor.add(block, least_beside(block, tree, blocks, steps)); });
    return corridor.take();
}

}  // namespace ossuary::skeleton
