#pragma once

#include "engine/mesh/mend_surface.h"
#include "engine/skeleton/skeleton_graph.h"

namespace ossuary::decomposition {

/// Turns the open patches of a surface so that they face away from the skeleton inside. An open
/// patch may be a dent or a wall of a larger body, whose own shape (mesh/orient.h) says the wrong
/// way or nothing; where the skeleton says nothing either, as in the middle of a sheet, the patch
/// stays as it is. Closed patches are left alone.
/// @param skeleton  refined, in the surface's units
void face_outwards(mesh::MendedSurface& surface, const skeleton::SkeletonGraph& skeleton);

}  // namespace ossuary::decomposition
