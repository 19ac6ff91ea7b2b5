#pragma once

#include <cstddef>

#include "engine/mesh/nearest_triangle.h"
#include "engine/registration/similarity.h"
#include "engine/registration/surface_points.h"

namespace ossuary::registration {

/// How far points of one surface are from another one, in its units.
struct OneSidedDistance {
    double mean = 0.0;
    double most = 0.0;  ///< what 95 % of the points keep within
    double greatest = 0.0;
    double explained = 0.0;  ///< share of the points within the tolerance asked for
};

/// Of the points of `source`, placed, from the triangles that `target` finds; exact but for the
/// sampling. Which way surfaces face does not count.
/// @param tolerance  in the target's units
/// @pre there are points; `target` is of `mesh`
[[nodiscard]] OneSidedDistance distance_to(const mesh::TriangleMesh& mesh,
                                           const mesh::NearestTriangle& target,
                                           const SurfacePoints& source, const Similarity& placement,
                                           double tolerance);

}  // namespace ossuary::registration
