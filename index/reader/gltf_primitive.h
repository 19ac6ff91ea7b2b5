#pragma once

#include <tiny_gltf.h>

#include "index/reader/gltf_accessors.h"
#include "index/reader/gltf_draco.h"

namespace ossuary::index {

/// The triangles of a primitive with its vertices' colours (COLOR_0): a list, strip or fan, indexed
/// or not, compressed or not. Points
/// and lines give none. Errors: gltf_invalid, model_too_many_vertices, model_too_many_faces.
Result<GltfTriangles> triangles_of(const tinygltf::Primitive& primitive, GltfAccessors& accessors,
                                   const mesh::ReadMeshOptions& caps);

/// Whether a primitive is of triangles at all.
[[nodiscard]] bool has_triangles(const tinygltf::Primitive& primitive);

}  // namespace ossuary::index
