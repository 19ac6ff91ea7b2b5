#include "engine/skeleton/anchors.h"

#include <bit>
#include <optional>
#include <utility>

#include "engine/skeleton/component_centres.h"
#include "engine/skeleton/corridor.h"
#include "engine/skeleton/finer_paths.h"
#include "engine/skeleton/padded_distance.h"
#include "engine/skeleton/shortest_paths.h"
#include "engine/skeleton/simple_point.h"

namespace ossuary::skeleton {
namespace {

/// Tips are searched in blocks such that the longest side has at most this many: a search voxel by
/// voxel takes 3.4 times as long at resolution 96 and finds as good ones (first tier of the ten
/// classes .789 voxel by voxel, .788 in blocks of 2x2x2).
constexpr int kLongestSideInBlocks = 64;

int block_edge_for(const voxel::BitVolume& solid) {
    int edge = 1;
    while (edge < 8 && solid.size().maxCoeff() > edge * kLongestSideInBlocks) edge *= 2;
    return edge;
}

/// The paths of the tips, voxel by voxel.
class PathLayer {
public:
    PathLayer(const ThinningGrid& corridor, const PaddedDistance& depth,
              const std::vector<VoxelIndex>& centres, const std::stop_token& stop)
        : steps_(corridor.shape().neighbor_steps()),
          paths_(shortest_paths(
              corridor, [](VoxelIndex) { return k26Neighbors; },
              [&](VoxelIndex v) { return depth.squared(v); }, centres, stop)) {}

    /// The voxel of a block with the longest way to its centre. @pre there is a way
    [[nodiscard]] VoxelIndex farthest_of(const BlockGrid& blocks, VoxelIndex block,
                                         const voxel::BitVolume& solid,
                                         const PaddedShape& shape) const {
        std::optional<VoxelIndex> farthest;
        blocks.for_each_voxel_of(solid, block, [&](const Vec3i& position) {
            const VoxelIndex v = shape.index(position);
            if (paths_.cost(v) == kUnreached) return;
            if (!farthest || paths_.cost(v) > paths_.cost(*farthest)) farthest = v;
        });
        return farthest.value();
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
            for (int look = 0; look < 3 && paths_.step(ahead) != kCentreBit; ++look) {
                ahead = paths_.next(ahead, steps_);
                if (are_neighbors(v, ahead)) next = ahead;
            }
            path.push_back(next);
        }
        std::reverse(path.begin(), path.end());
        return path;
    }

private:
    [[nodiscard]] bool are_neighbors(VoxelIndex a, VoxelIndex b) const {
        const auto step = static_cast<std::int32_t>(b - a);
        return std::find(steps_.begin(), steps_.end(), step) != steps_.end();
    }

    std::array<std::int32_t, 27> steps_;
    VoxelPaths paths_;
};

/// Where `v` closes a loop with the tree, as where it touches both sides of a corner, one more
/// voxel of the solid may fill the loop: adds one that is simple and makes `v` simple. Returns
/// whether there is one.
bool fill_beside(VoxelIndex v, const voxel::BitVolume& solid, ThinningGrid& tree) {
    const SimplePointTest& is_simple = SimplePointTest::shared();
    const auto steps = tree.shape().neighbor_steps();
    for (const Neighborhood kind : {kFaceNeighbors, kEdgeNeighbors, kCornerNeighbors}) {
        for (Neighborhood rest = kind & ~tree.neighborhood(v); rest != 0; rest &= rest - 1) {
            const auto bit = static_cast<std::size_t>(std::countr_zero(rest));
            const VoxelIndex beside = moved(v, steps[bit]);
            if (!solid.test_or_false(tree.shape().position(beside))) continue;
            if (!is_simple(tree.neighborhood(beside))) continue;
            tree.set(beside);
            if (is_simple(tree.neighborhood(v))) return true;
            tree.reset(beside);
        }
    }
    return false;
}

void add_path(const std::vector<VoxelIndex>& path, const voxel::BitVolume& solid,
              Anchors& anchors) {
    const SimplePointTest& is_simple = SimplePointTest::shared();
    for (const VoxelIndex v : path) {
        if (!is_simple(anchors.voxels.neighborhood(v)) && !fill_beside(v, solid, anchors.voxels)) {
            anchors.contractible = false;
        }
        anchors.voxels.set(v);
    }
}

}  // namespace

Anchors find_anchors(const voxel::BitVolume& solid, const voxel::DistanceField& distance,
                     const ThinningOptions& options, const std::stop_token& stop) {
    const PaddedShape shape(solid.size());
    Anchors anchors{ThinningGrid(shape), 0, true};
    BlockGrid blocks(solid, distance, block_edge_for(solid));
    std::vector<VoxelIndex> centres;
    std::vector<VoxelIndex> centre_blocks;
    for (const ComponentCentre& centre : component_centres(solid, distance)) {
        centres.push_back(centre.voxel);
        centre_blocks.push_back(blocks.block_of(shape.position(centre.voxel)));
        anchors.voxels.set(centre.voxel);
    }
    anchors.components = centres.size();
    if (centres.empty()) return anchors;

    const double coverage =
        std::max(options.coverage_voxels, options.coverage_share * solid.size().maxCoeff());
    Tips tips = find_tips(blocks, centre_blocks, coverage, options, stop);
    PathsInBlocks paths{std::move(blocks), std::move(tips)};
    while (paths.blocks.edge() > 2 && !stop.stop_requested()) {
        paths = finer_paths(paths, solid, distance, centres, stop);
    }
    if (stop.stop_requested()) return anchors;

    const PaddedDistance depth(distance, shape);
    const PathLayer layer(corridor_along(paths, solid, distance), depth, centres, stop);
    if (stop.stop_requested()) return anchors;
    std::vector<VoxelIndex> ends;
    for (const VoxelIndex block : paths.tips.blocks) {
        ends.push_back(layer.farthest_of(paths.blocks, block, solid, shape));
    }
    for (const VoxelIndex end : ends) {
        if (stop.stop_requested()) break;
        add_path(layer.path_from(end, anchors.voxels), solid, anchors);
    }
    return anchors;
}

}  // namespace ossuary::skeleton
