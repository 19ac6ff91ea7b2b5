#pragma once

#include <vector>

#include "engine/mesh/triangle_mesh.h"

namespace ossuary::mesh {

/// Sizes of a surface in model units. Only triangles with area count, where there are any; stray
/// vertices do not.
struct MeshMeasures {
    double surface_area = 0.0;
    /// By the divergence theorem; positive for a closed surface that faces outwards, meaningless
    /// for an open one.
    double signed_volume = 0.0;
    Vec3 area_centroid = Vec3::Zero();  ///< centroid of the surface, of the box where area is zero
    Box3 bounds;                        ///< empty for a mesh without triangles
    double diagonal = 0.0;              ///< of `bounds`
};

MeshMeasures measure(const TriangleMesh& mesh);

/// Area of one triangle.
[[nodiscard]] double triangle_area(const TriangleMesh& mesh, std::size_t triangle);

/// Area of each triangle.
[[nodiscard]] std::vector<double> triangle_areas(const TriangleMesh& mesh);

/// True when the triangle names a vertex twice or has no area beside its longest side (the height
/// over that side is below 1e-12 of it).
[[nodiscard]] bool is_degenerate(const TriangleMesh& mesh, std::size_t triangle);

}  // namespace ossuary::mesh
