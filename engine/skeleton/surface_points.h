#pragma once

#include <vector>

#include "engine/core/geometry.h"
#include "engine/mesh/triangle_mesh.h"

namespace ossuary::skeleton {

/// The surface of eq. 3.3 as points in voxels of the grid: the places of the vertices that
/// triangles use. Vertices at one place, to a thousandth of a voxel, are one point, whatever their
/// number; which of them stands for it does not depend on their order.
std::vector<Vec3> surface_points(const mesh::TriangleMesh& mesh,
                                 const WorldFromGrid& world_from_grid);

}  // namespace ossuary::skeleton
