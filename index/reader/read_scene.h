#pragma once

#include <string_view>

#include "engine/core/result.h"
#include "engine/mesh/read_mesh.h"
#include "engine/mesh/recognise_format.h"

namespace ossuary::index {

/// Reads a COLLADA, X3D, AMF or FBX file with assimp: all nodes with meshes, each an object, in the
/// file's own unit and axes. Files that it refers to are not looked for; colours are those of
/// vertices, else the material's diffuse one. Corners of an object at
/// equal positions become one vertex.
/// Errors: scene_invalid, with what assimp says; those of SceneBuilder.
Result<mesh::ReadMeshResult> read_scene(std::string_view bytes, mesh::ModelFormat format,
                                        const mesh::ReadMeshOptions& caps);

}  // namespace ossuary::index
