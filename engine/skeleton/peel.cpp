#include "engine/skeleton/peel.h"

#include <cstddef>

#include "engine/skeleton/simple_point.h"
#include "engine/voxel/border.h"

namespace ossuary {
namespace {

/// What to add to an index of the distance field to reach each neighbour.
std::array<std::ptrdiff_t, 27> distance_steps(const Vec3i& size) {
    std::array<std::ptrdiff_t, 27> steps{};
    for (int bit = 0; bit < 27; ++bit) {
        const NeighborOffset o = neighbor_offset(bit);
        steps[static_cast<std::size_t>(bit)] =
            (static_cast<std::ptrdiff_t>(o.dz) * size.y() + o.dy) * size.x() + o.dx;
    }
    return steps;
}

}  // namespace

ThinningGrid peel(const BitVolume& solid, const DistanceField& distance, const ThinningGrid& keep) {
    const SimplePointTest& is_simple = SimplePointTest::shared();
    ThinningGrid object(solid);
    const PaddedShape& shape = object.shape();
    const auto steps = shape.neighbor_steps();
    ThinningGrid queued(shape);
    ThinningGrid exposed(shape);  // what has had a background face: nothing else can be simple
    const std::array<std::ptrdiff_t, 27> depth_steps = distance_steps(distance.size());
    std::vector<std::vector<VoxelIndex>> levels;

    const auto enqueue = [&](VoxelIndex v, std::size_t level) {
        queued.set(v);
        if (level >= levels.size()) levels.resize(level + 1);
        levels[level].push_back(v);
    };
    for_each_voxel(border(solid), [&](const Vec3i& position) {
        const VoxelIndex v = shape.index(position);
        exposed.set(v);
        if (!keep.test(v)) enqueue(v, distance.squared(position));
    });

    // Within a level in waves from the border inwards, so that what has one depth throughout, such
    // as a plate, shrinks evenly from all sides.
    std::vector<VoxelIndex> wave;
    std::vector<VoxelIndex> next;
    for (std::size_t level = 0; level < levels.size(); ++level) {
        wave = std::move(levels[level]);
        while (!wave.empty()) {
            next.clear();
            for (const VoxelIndex v : wave) {
                queued.reset(v);
                const Neighborhood around = object.neighborhood(v);
                if (!is_simple(around)) continue;
                object.reset(v);
                for_each_bit(around & kFaceNeighbors, [&](int bit) {
                    exposed.set(moved(v, steps[static_cast<std::size_t>(bit)]));
                });
                const Neighborhood suspects = around & exposed.neighborhood(v) & k26Neighbors &
                                              ~keep.neighborhood(v) & ~queued.neighborhood(v);
                const std::uint32_t* depth_here =
                    distance.values().data() + distance.index(shape.position(v));
                for_each_bit(suspects, [&](int bit) {
                    const auto b = static_cast<std::size_t>(bit);
                    const VoxelIndex n = moved(v, steps[b]);
                    const std::size_t depth = depth_here[depth_steps[b]];
                    if (depth <= level) {
                        queued.set(n);
                        next.push_back(n);
                    } else {
                        enqueue(n, depth);
                    }
                });
            }
            std::swap(wave, next);
        }
    }
    return object;
}

}  // namespace ossuary
