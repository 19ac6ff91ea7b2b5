#include "engine/skeleton/peel.h"

#include "engine/skeleton/simple_point.h"
#include "engine/voxel/border.h"

namespace ossuary {

ThinningGrid peel(const BitVolume& solid, const DistanceField& distance, const ThinningGrid& keep) {
    const SimplePointTest& is_simple = SimplePointTest::shared();
    ThinningGrid object(solid);
    const PaddedShape& shape = object.shape();
    const auto steps = shape.neighbor_steps();
    ThinningGrid queued(shape);
    std::vector<std::vector<VoxelIndex>> levels;

    const auto enqueue = [&](VoxelIndex v, std::size_t level) {
        queued.set(v);
        if (level >= levels.size()) levels.resize(level + 1);
        levels[level].push_back(v);
    };
    for_each_voxel(border(solid), [&](const Vec3i& position) {
        const VoxelIndex v = shape.index(position);
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
                const Neighborhood exposed =
                    around & k26Neighbors & ~keep.neighborhood(v) & ~queued.neighborhood(v);
                for_each_bit(exposed, [&](int bit) {
                    const VoxelIndex n = moved(v, steps[static_cast<std::size_t>(bit)]);
                    const std::size_t depth = distance.squared(shape.position(n));
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
