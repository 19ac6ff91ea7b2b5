#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/mesh/triangle_mesh.h"

namespace ossuary::mesh {

/// What kind of surface a mesh is. Vertices are told apart by index: weld first to see whether a
/// soup closes up. Triangles that name a vertex twice take no part in edges and Euler number.
struct MeshReport {
    std::size_t vertices = 0;  ///< all of them
    std::size_t unreferenced_vertices = 0;
    std::size_t triangles = 0;
    std::size_t edges = 0;
    std::size_t boundary_edges = 0;      ///< one triangle
    std::size_t non_manifold_edges = 0;  ///< more than two triangles
    std::size_t misoriented_edges = 0;   ///< two triangles that run along it in the same direction
    std::size_t non_manifold_vertices = 0;  ///< more than one fan of triangles around them
    std::size_t degenerate_faces = 0;       ///< faces with a triangle that has no area
    std::size_t components = 0;             ///< by shared vertices
    long long euler_characteristic = 0;     ///< vertices in use - edges + triangles

    bool closed = false;         ///< no boundary edge, and at least one triangle
    bool edge_manifold = false;  ///< no non-manifold edge
    bool manifold = false;       ///< neither non-manifold edges nor vertices
    bool oriented = false;       ///< no misoriented edge
    /// Tunnels over all components, of a closed, manifold and oriented surface.
    std::optional<long long> genus;
};

MeshReport inspect(const TriangleMesh& mesh);

/// What is odd about a surface, for people and for the index. Codes: degenerate_faces,
/// non_manifold_edges, unreferenced_vertices, no_triangles.
std::vector<MeshWarning> surface_warnings(const TriangleMesh& mesh);

}  // namespace ossuary::mesh
