#pragma once

#include <string>
#include <string_view>

#include "engine/decomposition/rig.h"
#include "engine/decomposition/segmentation.h"
#include "engine/mesh/triangle_mesh.h"

namespace ossuary::index {

/// A rigged model as a binary glTF 2.0 file (.glb): one skinned mesh with a primitive and a colour
/// for each part (`extras.part` of its material), the joints as nodes (`extras.branch`). Positions
/// are float32 about the middle of the model; a node above the joints carries them to where the
/// model lies.
/// @param segmentation  the part of each triangle; @param rig  of the same mesh
/// @pre the mesh has a triangle
[[nodiscard]] std::string to_glb(const mesh::TriangleMesh& mesh,
                                 const decomposition::Segmentation& segmentation,
                                 const decomposition::Rig& rig, std::string_view name);

}  // namespace ossuary::index
