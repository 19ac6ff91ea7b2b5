#pragma once

#include <cstddef>
#include <stop_token>
#include <vector>

#include "engine/core/result.h"
#include "engine/mesh/triangle_mesh.h"

namespace ossuary::voxel {

struct WrapOptions {
    std::size_t min_points = 50;  ///< different ones; fewer say nothing of a shape
    int max_side = 256;           ///< grid points along the longest side of the points' box
};

/// What a set of points was taken to be the surface of.
struct WrappedPoints {
    mesh::TriangleMesh mesh;  ///< closed, facing outwards, the set's units
    double spacing = 0.0;     ///< typical distance from a point to its nearest, the set's units
    double radius = 0.0;      ///< gaps up to twice this are closed, the set's units
    std::size_t stray_points = 0;  ///< left out because they lie far from all others
};

/// The surface of the solid whose surface `points` lie on, without normals: balls around all
/// points, large enough by the points' own spacing to close the gaps between them; what these shut
/// in; and all of that shrunk by the balls' radius (morphological closing, on a grid of exact
/// distances). So dents and gaps narrower than twice the radius are closed, too; points of a sheet
/// give a plate of about a voxel. The result does not depend on the order of the points. Memory and
/// time follow the grid, and the number of points times its logarithm.
/// Errors: points_too_few, mesh_no_extent (all in one place), cancelled.
Result<WrappedPoints> wrap_points(const std::vector<Vec3>& points, const WrapOptions& options = {},
                                  const std::stop_token& stop = {});

}  // namespace ossuary::voxel
