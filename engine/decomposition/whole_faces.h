#pragma once

#include <cstdint>
#include <vector>

#include "engine/decomposition/surface_graph.h"

namespace ossuary::decomposition {

/// The faces that the triangles of a surface were cut from.
[[nodiscard]] std::size_t count_faces(const SurfaceGraph& surface);

/// Gives all triangles of a face the label that most of its area has (the least of equals), so that
/// no label runs through a face. Faces without area take the label of their first triangle.
void label_whole_faces(const SurfaceGraph& surface, std::vector<std::uint32_t>& labels);

}  // namespace ossuary::decomposition
