#pragma once

#include "engine/skeleton/row_layout.h"
#include "engine/voxel/distance_transform.h"

namespace ossuary::skeleton {

/// A solid at a fraction of its resolution: blocks of edge^3 voxels that hold some of it, with
/// links between two blocks where a voxel of one is a 26-neighbour of a voxel of the other. Up to
/// edge 2 the voxels of a block are all neighbours of each other, so that a chain of linked blocks
/// always holds a chain of voxels; with larger blocks two parts of the solid may share one
/// unjoined.
class BlockGrid {
public:
    /// @param edge  1, 2, 4 or 8 voxels
    BlockGrid(const voxel::BitVolume& solid, const voxel::DistanceField& distance, int edge);
    /// Only of the blocks among `candidates`, as if the solid had no voxels elsewhere: the cost
    /// follows their number.
    BlockGrid(const voxel::BitVolume& solid, const voxel::DistanceField& distance, int edge,
              ThinningGrid candidates);

    /// Of the grid of all blocks.
    static PaddedShape shape_of(const voxel::BitVolume& solid, int edge) {
        return PaddedShape((solid.size().array() + (edge - 1)) / edge);
    }

    [[nodiscard]] int edge() const { return edge_; }
    [[nodiscard]] const PaddedShape& shape() const { return occupied_.shape(); }
    [[nodiscard]] const ThinningGrid& occupied() const { return occupied_; }
    [[nodiscard]] const RowLayout& layout() const { return layout_; }
    /// The linked neighbours of an occupied block.
    [[nodiscard]] Neighborhood links(VoxelIndex block) const {
        return links_[layout_.place(block)];
    }
    /// Of the block's deepest voxel, squared, in voxels.
    [[nodiscard]] std::uint32_t squared_radius(VoxelIndex block) const {
        return squared_[layout_.place(block)];
    }

    [[nodiscard]] VoxelIndex block_of(const Vec3i& voxel) const {
        return shape().index(voxel / edge_);
    }
    /// Calls `visit(Vec3i)` for every voxel of the solid in a block.
    template <typename Visit>
    void for_each_voxel_of(const voxel::BitVolume& solid, VoxelIndex block, Visit&& visit) const {
        const Vec3i first = shape().position(block) * edge_;
        const Vec3i end = (first.array() + edge_).min(solid.size().array()).matrix();
        for (int z = first.z(); z < end.z(); ++z) {
            for (int y = first.y(); y < end.y(); ++y) {
                for (std::uint64_t bits = bits_of_row(solid, first.x(), y, z); bits != 0;
                     bits &= bits - 1) {
                    visit(Vec3i(first.x() + std::countr_zero(bits), y, z));
                }
            }
        }
    }

private:
    /// The voxels of a block in one of its rows; `x` is the block's first.
    [[nodiscard]] std::uint64_t bits_of_row(const voxel::BitVolume& solid, int x, int y,
                                            int z) const {
        const auto column = static_cast<std::size_t>(x);
        return solid.row(y, z)[column / 64] >> column % 64 & ((std::uint64_t{1} << edge_) - 1);
    }
    /// Measures a block. Returns what its voxels reach, with itself; nothing where it has none.
    Neighborhood add_block(const voxel::BitVolume& solid, const voxel::DistanceField& distance,
                           VoxelIndex block);
    /// @param reached  by place
    void link(const std::vector<Neighborhood>& reached);

    int edge_;
    ThinningGrid occupied_;
    RowLayout layout_;
    std::vector<Neighborhood> links_;  ///< by place, as the next
    std::vector<std::uint32_t> squared_;
};

}  // namespace ossuary::skeleton
