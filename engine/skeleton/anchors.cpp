#include "engine/skeleton/anchors.h"

#include "engine/skeleton/component_centres.h"
#include "engine/skeleton/shortest_paths.h"
#include "engine/skeleton/simple_point.h"
#include "engine/skeleton/tip_search.h"

namespace ossuary {
namespace {

/// Up to this many voxels along the longest side tips are searched voxel by voxel, above it in
/// blocks of 2x2x2, which is eight times less.
constexpr int kLongestSideInVoxels = 64;

/// The voxels of the tree's blocks and of those linked to them.
ThinningGrid corridor_along(const ThinningGrid& tree, const BlockGrid& blocks,
                            const BitVolume& solid) {
    ThinningGrid wide = tree;
    const auto steps = blocks.shape().neighbor_steps();
    tree.for_each([&](VoxelIndex b) {
        for_each_bit(blocks.links(b),
                     [&](int bit) { wide.set(moved(b, steps[static_cast<std::size_t>(bit)])); });
    });
    ThinningGrid corridor{PaddedShape(solid.size())};
    wide.for_each([&](VoxelIndex b) {
        blocks.for_each_voxel_of(solid, b,
                                 [&](const Vec3i& v) { corridor.set(corridor.shape().index(v)); });
    });
    return corridor;
}

/// The paths of the tips, voxel by voxel.
class PathLayer {
public:
    PathLayer(const ThinningGrid& corridor, const DistanceField& distance,
              const std::vector<VoxelIndex>& centres)
        : steps_(corridor.shape().neighbor_steps()),
          squared_(corridor, 0),
          paths_(find_paths(corridor, distance, centres)) {}

    /// The voxel of a block with the longest way to its centre.
    [[nodiscard]] VoxelIndex farthest_of(const BlockGrid& blocks, VoxelIndex block,
                                         const BitVolume& solid, const PaddedShape& shape) const {
        VoxelIndex best = 0;
        float worst = -1.0f;
        blocks.for_each_voxel_of(solid, block, [&](const Vec3i& position) {
            const VoxelIndex v = shape.index(position);
            if (paths_.cost[v] > worst) {
                worst = paths_.cost[v];
                best = v;
            }
        });
        return best;
    }

    /// From the first voxel next to the tree out to the tip, without detours: of the next steps the
    /// farthest that is still a neighbour is taken.
    [[nodiscard]] std::vector<VoxelIndex> path_from(VoxelIndex tip,
                                                    const ThinningGrid& tree) const {
        std::vector<VoxelIndex> path;
        if (tree.test(tip)) return path;
        path.push_back(tip);
        while ((tree.neighborhood(path.back()) & k26Neighbors) == 0) {
            const VoxelIndex v = path.back();
            VoxelIndex next = paths_.next(v, steps_);
            VoxelIndex ahead = next;
            for (int look = 0; look < 3 && paths_.step[ahead] != kCentreBit; ++look) {
                ahead = paths_.next(ahead, steps_);
                if (are_neighbors(v, ahead)) next = ahead;
            }
            path.push_back(next);
        }
        std::reverse(path.begin(), path.end());
        return path;
    }

private:
    ShortestPaths find_paths(const ThinningGrid& corridor, const DistanceField& distance,
                             const std::vector<VoxelIndex>& centres) {
        corridor.for_each(
            [&](VoxelIndex v) { squared_[v] = distance.squared(corridor.shape().position(v)); });
        return shortest_paths(
            corridor, [](VoxelIndex) { return k26Neighbors; },
            [&](VoxelIndex v) { return squared_[v]; }, centres);
    }
    [[nodiscard]] bool are_neighbors(VoxelIndex a, VoxelIndex b) const {
        const auto step = static_cast<std::int32_t>(b - a);
        return std::find(steps_.begin(), steps_.end(), step) != steps_.end();
    }

    std::array<std::int32_t, 27> steps_;
    VoxelMap<std::uint32_t> squared_;  ///< distance to the background, squared
    ShortestPaths paths_;
};

void add_path(const std::vector<VoxelIndex>& path, Anchors& anchors) {
    const SimplePointTest& is_simple = SimplePointTest::shared();
    for (const VoxelIndex v : path) {
        if (!is_simple(anchors.voxels.neighborhood(v))) anchors.contractible = false;
        anchors.voxels.set(v);
    }
}

}  // namespace

Anchors find_anchors(const BitVolume& solid, const DistanceField& distance,
                     const ThinningOptions& options) {
    const PaddedShape shape(solid.size());
    Anchors anchors{ThinningGrid(shape), 0, 0, true};
    const BlockGrid blocks(solid, distance,
                           solid.size().maxCoeff() <= kLongestSideInVoxels ? 1 : 2);
    std::vector<VoxelIndex> centres;
    std::vector<VoxelIndex> centre_blocks;
    for (const ComponentCentre& centre : component_centres(solid, distance)) {
        centres.push_back(centre.voxel);
        centre_blocks.push_back(blocks.block_of(shape.position(centre.voxel)));
        anchors.voxels.set(centre.voxel);
    }
    anchors.components = centres.size();
    if (centres.empty()) return anchors;

    const Tips tips = find_tips(blocks, centre_blocks, options);
    const PathLayer layer(corridor_along(tips.tree, blocks, solid), distance, centres);
    for (const VoxelIndex block : tips.blocks) {
        const VoxelIndex tip = layer.farthest_of(blocks, block, solid, shape);
        const std::vector<VoxelIndex> path = layer.path_from(tip, anchors.voxels);
        if (path.empty()) continue;
        add_path(path, anchors);
        ++anchors.tips;
    }
    return anchors;
}

}  // namespace ossuary
