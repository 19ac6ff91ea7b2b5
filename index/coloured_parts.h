#pragma once

#include <cstdint>
#include <vector>

#include "engine/decomposition/segmentation.h"
#include "engine/mesh/write_mesh.h"

namespace ossuary::index {

/// The colour of a part, red, green and blue: hues a golden angle apart, so that parts with
/// neighbouring numbers are easy to tell from each other.
[[nodiscard]] mesh::Colour part_colour(std::uint32_t part);

/// The colour of the part of each triangle.
[[nodiscard]] std::vector<mesh::Colour> part_colours(
    const decomposition::Segmentation& segmentation);

}  // namespace ossuary::index
