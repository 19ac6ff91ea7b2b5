#pragma once

#include "engine/skeleton/simple_point.h"

namespace ossuary::skeleton {

/// Whether a voxel is P-simple: simple whichever others of the candidate set P have gone before it,
/// so that all P-simple points of P may be deleted together without changing the topology. Local
/// characterisation for (26, 6) by Bertrand, "On P-simple points", 1995; see Lohou & Dehos,
/// "Automatic correction of Ma and Sonka's thinning algorithm using P-simple points", TPAMI 2010.
/// @param object      the object around the voxel, candidates included
/// @param candidates  P around the voxel, a subset of `object`
[[nodiscard]] bool is_p_simple(const SimplePointTest& simple_point, Neighborhood object,
                               Neighborhood candidates);

}  // namespace ossuary::skeleton
