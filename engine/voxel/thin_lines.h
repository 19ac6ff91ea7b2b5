#pragma once

#include <cstdint>
#include <vector>

#include "engine/voxel/bit_volume.h"
#include "engine/voxel/grid_mesh.h"
#include "engine/voxel/ray_columns.h"

namespace ossuary::voxel {

/// Longer triangles, in one axis, can hide something between their corners.
inline constexpr std::int32_t kLongEdge = 4 * kGridOne;

/// The triangles at which a solid, sampled at voxel centres, may have lost something of its
/// surface: with a corner that has nothing thick around it (morphology.h), or longer than
/// kLongEdge, so that the corners do not tell enough. Elsewhere lines that miss all centres only
/// graze the outline.
std::vector<std::uint32_t> find_thin_places(const GridMesh& mesh, const BitVolume& solid);

/// The lines along an axis that pass by thin places, and what they may cross.
/// @param candidates  the triangles to choose from
/// @param thin_places  find_thin_places
LineSubset lines_past(const GridMesh& mesh, const std::vector<std::uint32_t>& candidates,
                      const std::vector<std::uint32_t>& thin_places, int axis);

}  // namespace ossuary::voxel
