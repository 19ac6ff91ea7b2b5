#pragma once

#include <stop_token>

#include "engine/core/result.h"
#include "engine/decomposition/segmentation.h"
#include "engine/mesh/triangle_mesh.h"

namespace ossuary::decomposition {

/// The parts of a mesh on a coarser copy of it (decimate.h): each triangle of the copy has the part
/// of the triangle nearest to its centre, of sheets that lie together the one that faces the same
/// way. A part that is nearest to none still gets the triangle nearest to its largest one, of those
/// whose own part has others, so that no part is lost. A copy that lacks nothing but triangles
/// without corners of their own keeps the labels as they are. Deterministic.
/// @param segmentation  of the triangles of `mesh`
/// @return  the part of each triangle of `copy`, numbered as in `segmentation`
/// @pre the mesh has a triangle
/// Errors: invalid_argument (fewer triangles in the copy than parts), cancelled.
Result<Segmentation> carry_labels(const mesh::TriangleMesh& mesh, const Segmentation& segmentation,
                                  const mesh::TriangleMesh& copy, const std::stop_token& stop = {});

}  // namespace ossuary::decomposition
