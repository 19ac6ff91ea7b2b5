#pragma once

#include "engine/skeleton/thinning_grid.h"
#include "engine/skeleton/voxel_map.h"
#include "engine/voxel/distance_transform.h"

namespace ossuary {

/// A solid at half its resolution, its topology of contacts kept: blocks of 2x2x2 voxels (or single
/// voxels) that hold some of the solid, with links between two blocks where a voxel of one is a
/// 26-neighbour of a voxel of the other. The voxels of a block are all neighbours of each other, so
/// a chain of linked blocks always holds a chain of voxels.
class BlockGrid {
public:
    /// @param edge  1 or 2 voxels
    BlockGrid(const BitVolume& solid, const DistanceField& distance, int edge);

    [[nodiscard]] int edge() const { return edge_; }
    [[nodiscard]] const PaddedShape& shape() const { return occupied_.shape(); }
    [[nodiscard]] const ThinningGrid& occupied() const { return occupied_; }
    /// The linked neighbours of an occupied block.
    [[nodiscard]] Neighborhood links(VoxelIndex block) const { return links_[block]; }
    /// Of the block's deepest voxel, squared, in voxels.
    [[nodiscard]] std::uint32_t squared_radius(VoxelIndex block) const { return squared_[block]; }

    [[nodiscard]] VoxelIndex block_of(const Vec3i& voxel) const {
        return shape().index(voxel / edge_);
    }
    /// Calls `visit(Vec3i)` for every voxel of the solid in a block.
    template <typename Visit>
    void for_each_voxel_of(const BitVolume& solid, VoxelIndex block, Visit&& visit) const {
        const Vec3i first = shape().position(block) * edge_;
        const Vec3i end = (first.array() + edge_).min(solid.size().array()).matrix();
        for (int z = first.z(); z < end.z(); ++z) {
            for (int y = first.y(); y < end.y(); ++y) {
                for (int x = first.x(); x < end.x(); ++x) {
                    if (solid.test(x, y, z)) visit(Vec3i(x, y, z));
                }
            }
        }
    }

private:
    int edge_;
    ThinningGrid occupied_;
    VoxelMap<Neighborhood> links_;
    VoxelMap<std::uint32_t> squared_;
};

}  // namespace ossuary
