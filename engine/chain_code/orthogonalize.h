#pragma once

#include <span>
#include <vector>

#include "engine/core/geometry.h"

namespace ossuary::chain_code {

/// A branch as a path over voxels in which each step goes to a face neighbour (thesis sec. 3.3.2,
/// "orthogonalization"): the voxels that the branch's points lie in, joined by unit steps. Where
/// more than one step leads on, the one with the highest chain code descriptor (eq. 3.5) is taken;
/// where those are equal, the one along the axis that the whole branch goes farthest on, then the
/// lower axis. Steps that would be taken back at once are left out.
/// @param polyline  in voxel units, at least one point
/// @return voxels, at least one; the first and last are those of the polyline's ends unless the
///         branch turns back on itself there
[[nodiscard]] std::vector<Vec3i> orthogonalize(std::span<const Vec3> polyline);

}  // namespace ossuary::chain_code
