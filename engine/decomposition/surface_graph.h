#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/core/geometry.h"
#include "engine/mesh/triangle_mesh.h"

namespace ossuary::decomposition {

/// A surface as a graph of its triangles: who lies across which side, and how the surface turns
/// there.
struct SurfaceGraph {
    std::vector<Vec3> centers;  ///< model units
    std::vector<Vec3> normals;  ///< unit length; zero for triangles without area
    std::vector<double> areas;  ///< model units squared
    /// For each side the triangle across; kNoTriangle on boundaries and non-manifold edges.
    std::vector<std::array<std::uint32_t, 3>> across;
    /// How far the normals of the two are apart, |n - n'|: positive where the surface is concave,
    /// negative where it is convex, in [-2, 2].
    std::vector<std::array<float, 3>> turns;
    std::vector<std::array<float, 3>> side_lengths;  ///< model units
    /// Of each triangle the first one that it may not be parted from: of the same face of the file,
    /// or itself.
    std::vector<std::uint32_t> first_of_face;
    double total_area = 0.0;

    [[nodiscard]] std::size_t size() const { return centers.size(); }
};

/// @param mesh  vertices told apart by index, and facing outwards: mend it first (mend_surface.h);
///     without `face_of_triangle` each triangle is a face
/// @param whole_faces  whether triangles that were cut from one face belong together
SurfaceGraph surface_graph(const mesh::TriangleMesh& mesh, bool whole_faces = false);

/// The pieces of the graph, numbered by their first triangle.
struct SurfacePieces {
    std::vector<std::uint32_t> of_triangle;
    std::vector<double> areas;
};
SurfacePieces surface_pieces(const SurfaceGraph& graph);

}  // namespace ossuary::decomposition
