#pragma once

#include <vector>

#include "engine/mesh/triangle_mesh.h"

namespace ossuary::mesh {

/// Unit normals at the vertices: the triangles' normals weighted by their angle at the vertex
/// (Thürmer and Wüthrich, Computing Vertex Normals from Polygonal Facets, 1998), which does not
/// depend on how the surface is cut into triangles. Zero where no triangle with area meets.
std::vector<Vec3> vertex_normals(const TriangleMesh& mesh);

/// Unit normals of the triangles; zero for those without area.
std::vector<Vec3> triangle_normals(const TriangleMesh& mesh);

}  // namespace ossuary::mesh
