#pragma once

#include <cstddef>

#include "engine/mesh/triangle_mesh.h"

namespace ossuary {

/// Coarsens any surface, soups included: vertices that share a cell of a cubic grid become one, at
/// their mean weighted by the area around them; triangles that collapse or repeat are dropped
/// (Rossignac and Borrel, Multi-resolution 3D Approximations, 1993). The grid is the finest one, of
/// at most 1024 cells along the longest side, that leaves at most `max_triangles`.
TriangleMesh cluster_vertices(const TriangleMesh& mesh, std::size_t max_triangles);

}  // namespace ossuary
