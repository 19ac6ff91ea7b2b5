#pragma once

#include <stop_token>

#include "engine/mesh/triangle_mesh.h"
#include "engine/voxel/scalar_grid.h"

namespace ossuary::voxel {

/// The surface around all points of a grid that are at `level` or above, facing away from them:
/// dual marching cubes (Nielson, Dual Marching Cubes, 2004), one vertex for each piece of the
/// surface in a cell, in the middle of where that piece crosses the cell's edges. Closed; every
/// edge belongs to an even number of triangles, nearly all to two. Points above the level that
/// touch across a face's or a cell's diagonal hold together. Two triangles a face, whose number is
/// that of the grid's edges that cross the level. Not complete when `stop` is requested.
/// @pre all values on the grid's border are below `level`
mesh::TriangleMesh level_surface(const ScalarGrid& grid, float level,
                                 const std::stop_token& stop = {});

}  // namespace ossuary::voxel
