#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/mesh/orient.h"
#include "engine/mesh/triangle_mesh.h"

namespace ossuary::mesh {

/// A surface as whatever looks along its normals or across its edges needs it, and where its
/// triangles and vertices come from.
struct MendedSurface {
    /// Vertices in order of first use, none unused; no triangle twice; each begins at its first
    /// corner by position. Triangles that name a vertex twice stay.
    TriangleMesh mesh;
    std::vector<std::uint32_t> vertex_of;    ///< of each vertex of the input; kUnused if in no face
    std::vector<std::uint32_t> triangle_of;  ///< that stands for each triangle of the input
    std::vector<std::uint8_t> turned;        ///< of each triangle of `mesh`: lies the other way
    std::vector<OrientedPatch> patches;      ///< of `mesh`
    std::vector<std::uint32_t> patch_of;     ///< of each triangle of `mesh`
    std::size_t repeated_triangles = 0;

    static constexpr std::uint32_t kUnused = 0xFFFFFFFFU;
};

/// Joins the seams of a surface, leaves out triangles that come again, and turns what is left
/// outwards (orient.h), so that the result depends on what the faces cover and not on how they lie:
/// faces that are turned over, come twice or have vertices of their own give the same surface. A
/// surface without such faults keeps its vertices and triangles as they are, but for the order of
/// vertices and which corner a triangle begins with.
///
/// Seams are closed where vertices are at most 1e-5 of the model's size apart, but not farther than
/// a quarter of the shortest edge at either, so that nothing that is meant falls together; below
/// 1e-6 of the size nothing is meant. The size is the bounding box's diagonal or the square root of
/// the area, whichever is less: a speck far away changes the former only.
MendedSurface mend_surface(const TriangleMesh& mesh);

/// Turns the chosen patches over.
/// @param chosen  for each patch
void turn_over(MendedSurface& surface, const std::vector<bool>& chosen);

/// What was wrong with how the faces lie, for people and for the index. Codes: turned_faces (lie
/// the other way than most around them, or look into their piece, which is no fault of one that may
/// be the inside of another, nor of flat ones), repeated_triangles.
std::vector<MeshWarning> mending_warnings(const MendedSurface& surface);

}  // namespace ossuary::mesh
