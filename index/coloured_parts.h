#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "engine/decomposition/segmentation.h"
#include "engine/mesh/triangle_mesh.h"

namespace ossuary::index {

/// The colour of a part, red, green and blue: hues a golden angle apart, so that parts with
/// neighbouring numbers are easy to tell from each other.
[[nodiscard]] std::array<std::uint8_t, 3> part_colour(std::uint32_t part);

/// The mesh as a binary little-endian PLY file whose faces have their part's colour.
/// @param segmentation  a label for each triangle
[[nodiscard]] std::string coloured_ply(const mesh::TriangleMesh& mesh,
                                       const decomposition::Segmentation& segmentation);

}  // namespace ossuary::index
