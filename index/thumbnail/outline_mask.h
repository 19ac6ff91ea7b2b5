#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/mesh/triangle_mesh.h"

namespace ossuary::index {

/// Marks (with 1) the pixels of a size * size picture, rows from the top, through which an edge
/// runs where the picture may change abruptly: outlines (the triangles on both sides of the edge
/// project to the same side of it), boundaries, non-manifold edges and creases. Whether something
/// hides the edge is not asked. `vertices` are those of the mesh in pixels, x to the right and y
/// downwards, z towards the viewer in the same unit.
std::vector<std::uint8_t> outline_mask(const mesh::TriangleMesh& mesh,
                                       std::span<const Vec3f> vertices, int size);

}  // namespace ossuary::index
