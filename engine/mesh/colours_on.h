#pragma once

#include <vector>

#include "engine/mesh/triangle_mesh.h"

namespace ossuary::mesh {

/// Whether each triangle has one colour, so that colours change at edges only.
[[nodiscard]] bool has_flat_colours(const TriangleMesh& mesh);

/// Whether a mesh has colours that are all white, as of a scene whose materials say nothing.
[[nodiscard]] bool is_white(const TriangleMesh& mesh);

/// The colours of a mesh on a coarser copy of it. Where its triangles have one colour each, so have
/// those of the copy: that of the triangle nearest to the middle, of sheets that lie together the
/// one that faces the same way. Else the copy's vertices have the colour of the point of the mesh
/// nearest to them. Deterministic.
/// @return  of the corners of each triangle of `copy`; empty where `mesh` has no colours
[[nodiscard]] std::vector<CornerColours> colours_on(const TriangleMesh& copy,
                                                    const TriangleMesh& mesh);

/// The colour at a point of a triangle.
/// @param weights  of its corners, not negative, one in sum
[[nodiscard]] Colour colour_at(const CornerColours& colours, const Vec3& weights);

}  // namespace ossuary::mesh
