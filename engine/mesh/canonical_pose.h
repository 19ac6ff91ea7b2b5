#pragma once

#include "engine/core/geometry.h"
#include "engine/mesh/triangle_mesh.h"

namespace ossuary::mesh {

/// The model's own axes as columns, in model coordinates: the principal axes of its surface, widest
/// first, each pointing to the side on which the surface reaches farther (the third moment along it
/// is not negative). A copy that is moved, turned, mirrored, scaled or renumbered has the same axes
/// on it, so the matrix is orthonormal but may have determinant -1; axes along which the surface is
/// the same both ways, or equally wide, are as the numbers fall.
/// A mesh without area gets the identity.
Mat3 canonical_pose(const TriangleMesh& mesh);

}  // namespace ossuary::mesh
