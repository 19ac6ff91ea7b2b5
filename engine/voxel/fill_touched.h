#pragma once

#include <cstddef>
#include <cstdint>
#include <stop_token>

#include "engine/voxel/bit_volume.h"
#include "engine/voxel/grid_mesh.h"

namespace ossuary::voxel {

/// How far fill_touched has come.
struct TouchedSurface {
    std::size_t triangles = 0;  ///< looked at; all, unless stopped or out of work
    std::uint64_t work = 0;
};

/// Sets every voxel that the surface passes through, give or take half a voxel: what is left to do
/// where it passes everywhere and inside and outside cannot be told apart. Triangles among voxels
/// that are set already are not looked at, so that a dense soup costs what its first thousands of
/// triangles cost. They are looked at in a shuffled order that follows from where they lie: where
/// the work does not suffice for all, the rest is as good as a random sample, and the same for
/// every numbering of the triangles.
/// @param most_work  places looked at, some 3 ns each
TouchedSurface fill_touched(const GridMesh& mesh, std::uint64_t most_work,
                            const std::stop_token& stop, BitVolume& volume);

}  // namespace ossuary::voxel
