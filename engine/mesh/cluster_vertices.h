#pragma once

#include <cstddef>

#include "engine/mesh/triangle_mesh.h"

namespace ossuary::mesh {

/// Coarsens any surface, soups included: vertices that share a cell of a cubic grid become one, at
/// their mean weighted by the area around them; triangles that collapse or repeat are dropped
/// (Rossignac and Borrel, Multi-resolution 3D Approximations for Rendering Complex Scenes, 1993).
/// The grid, of at most 1024 cells along the longest side, is chosen so that nearly `max_triangles`
/// are left where it can be, and never more. Keeps no topology; each triangle keeps its colours.
/// Empty for a mesh without extent.
TriangleMesh cluster_vertices(const TriangleMesh& mesh, std::size_t max_triangles);

}  // namespace ossuary::mesh
