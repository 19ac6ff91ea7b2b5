#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/voxel/bit_volume.h"

namespace ossuary::voxel {

enum class Connectivity {
    kFaces,     ///< 6 neighbours: the background's
    kVertices,  ///< 26 neighbours: the foreground's
};

/// A maximal stretch of set voxels along x: x in [begin, end).
struct VoxelRun {
    std::int32_t begin = 0;
    std::int32_t end = 0;
    std::int32_t y = 0;
    std::int32_t z = 0;
    std::uint32_t component = 0;
};

/// The connected components of a volume, run-length coded: a few bytes a run instead of a label a
/// voxel.
struct Components {
    std::vector<VoxelRun> runs;             ///< x fastest, then y, then z
    std::vector<std::size_t> voxel_counts;  ///< of each component, numbered by its first run

    [[nodiscard]] std::size_t count() const { return voxel_counts.size(); }
};

/// Labels the set voxels.
Components label_components(const BitVolume& volume, Connectivity connectivity);

/// Labels the background by faces; component 0 is what reaches beyond the volume's border (its
/// count is that of its voxels in the volume, 0 when the border is full), the others are cavities.
Components label_background(const BitVolume& volume);

/// Sets every voxel of the runs.
void set_run(BitVolume& volume, const VoxelRun& run);
void reset_run(BitVolume& volume, const VoxelRun& run);

struct FilledCavities {
    std::size_t cavities = 0;
    std::size_t voxels = 0;
};
/// Sets every background voxel that cannot reach the outside through faces.
FilledCavities fill_cavities(BitVolume& volume);

}  // namespace ossuary::voxel
