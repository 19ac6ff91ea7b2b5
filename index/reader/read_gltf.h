#pragma once

#include <string_view>

#include "engine/core/result.h"
#include "engine/mesh/read_mesh.h"
#include "index/reader/companions.h"

namespace ossuary::index {

/// Reads a glTF 2 document or a GLB with tinygltf: the triangles of its scene (the first one where
/// it names none; all nodes where it has no scene), placed by its nodes, each node with a mesh an
/// object. Meshes are taken as they are stored, before skins and morph targets move them. In
/// metres, y points up. Colours are those of vertices (COLOR_0) times the material's base colour,
/// without pictures. Corners of an object at equal positions become one vertex. Errors: those of
/// open_gltf, GltfAccessors and SceneBuilder.
Result<mesh::ReadMeshResult> read_gltf(std::string_view bytes, const mesh::ReadMeshOptions& caps,
                                       const AskForFile& ask);

}  // namespace ossuary::index
