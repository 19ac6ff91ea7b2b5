#include "engine/voxel/close_gaps.h"

#include <utility>

#include "engine/voxel/components.h"
#include "engine/voxel/morphology.h"

namespace ossuary::voxel {
namespace {

constexpr int kMargin = 2;

/// Outside of the volume counts as empty where it grows and as full where it shrinks, so that its
/// edge would stay full: what is grown into the margin is taken away again.
void clear_margin(BitVolume& volume) {
    const Vec3i size = volume.size();
    for (int z = 0; z < size.z(); ++z) {
        for (int y = 0; y < size.y(); ++y) {
            const bool inner =
                y >= kMargin && z >= kMargin && y + kMargin < size.y() && z + kMargin < size.z();
            if (!inner) {
                reset_run(volume, {0, size.x(), y, z, 0});
                continue;
            }
            reset_run(volume, {0, kMargin, y, z, 0});
            reset_run(volume, {size.x() - kMargin, size.x(), y, z, 0});
        }
    }
}

}  // namespace

std::size_t intricacy(const BettiNumbers& shape) {
    return static_cast<std::size_t>(shape.components) + static_cast<std::size_t>(shape.tunnels) +
           static_cast<std::size_t>(shape.cavities);
}

int close_gaps(BitVolume& volume, std::size_t most, const std::stop_token& stop) {
    int width = 0;
    for (int reach = 1; intricacy(betti_numbers(volume)) > most; reach *= 2) {
        BitVolume closed = volume;
        for (int i = 0; i < reach && !stop.stop_requested(); ++i) closed = dilate(closed);
        for (int i = 0; i < reach && !stop.stop_requested(); ++i) closed = erode(closed);
        if (stop.stop_requested()) break;
        clear_margin(closed);
        fill_cavities(closed);
        volume = std::move(closed);
        width = 2 * reach;
        // By then everything is one block.
        if (reach > volume.size().maxCoeff()) break;
    }
    return width;
}

}  // namespace ossuary::voxel
