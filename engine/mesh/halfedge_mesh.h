#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "engine/mesh/triangle_mesh.h"

namespace ossuary::mesh {

/// What had to be done to fit a surface into halfedges, where at most two triangles share an edge,
/// in opposite directions, and one fan of triangles surrounds each vertex.
struct HalfedgeReport {
    std::size_t dropped_triangles = 0;    ///< that named a vertex twice
    std::size_t duplicated_vertices = 0;  ///< copies made to part fans that meet in a vertex only
    std::size_t detached_triangles = 0;   ///< that found no place next to their neighbours
};

/// The connectivity of a triangle mesh (OpenMesh's halfedges behind it). Any soup can be held: the
/// surface is cut open at non-manifold and misoriented edges and non-manifold vertices by
/// duplicating vertices, so that no triangle is lost but those that name a vertex twice.
class HalfedgeMesh {
public:
    explicit HalfedgeMesh(const TriangleMesh& mesh);
    ~HalfedgeMesh();
    HalfedgeMesh(HalfedgeMesh&& other) noexcept;
    HalfedgeMesh& operator=(HalfedgeMesh&& other) noexcept;
    HalfedgeMesh(const HalfedgeMesh&) = delete;
    HalfedgeMesh& operator=(const HalfedgeMesh&) = delete;

    [[nodiscard]] const HalfedgeReport& report() const;
    [[nodiscard]] std::size_t vertex_count() const;
    [[nodiscard]] std::size_t edge_count() const;
    [[nodiscard]] std::size_t triangle_count() const;
    /// Closed walks along the boundary.
    [[nodiscard]] std::size_t boundary_loop_count() const;
    [[nodiscard]] bool is_boundary(std::uint32_t vertex) const;

    /// The vertex of the mesh given to the constructor that `vertex` is or was copied from.
    /// @pre no decimation has taken place
    [[nodiscard]] std::uint32_t source_vertex(std::uint32_t vertex) const;
    /// The vertices around `vertex`, in order around it.
    [[nodiscard]] std::vector<std::uint32_t> one_ring(std::uint32_t vertex) const;

    /// Collapses edges in the order of their quadric error (Garland and Heckbert, Surface
    /// Simplification Using Quadric Error Metrics, 1997) until at most `max_triangles` are left or
    /// no collapse keeps the surface's topology. Open boundaries stay where they are as far as
    /// possible. Returns the number of triangles left.
    std::size_t decimate_quadric(std::size_t max_triangles);

    /// The surface as a plain mesh. `face_of_triangle` numbers the triangles themselves.
    [[nodiscard]] TriangleMesh to_triangle_mesh() const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace ossuary::mesh
