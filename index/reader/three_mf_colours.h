#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/mesh/colour.h"
#include "index/reader/three_mf_instance.h"

namespace ossuary::index {

/// Of each triangle of a mesh, where it has any; empty where no triangle has.
using ThreeMfColours = std::vector<std::optional<mesh::CornerColours>>;

/// The colours of the triangles of a mesh in a 3MF package: of base materials, which colour a
/// triangle, and of colour groups, which colour its corners; where a triangle has none, its
/// object's. Textures and mixtures give none.
/// @param object  a mesh object of `model`
[[nodiscard]] ThreeMfColours three_mf_colours(NMR::PLib3MFBase* model, NMR::PLib3MFBase* object,
                                              std::uint32_t triangles);

}  // namespace ossuary::index
