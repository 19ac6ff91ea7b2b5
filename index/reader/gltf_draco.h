#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/geometry.h"
#include "engine/core/result.h"
#include "engine/mesh/read_mesh.h"

namespace ossuary::index {

/// Triangles as they come out of a primitive of a glTF document.
struct GltfTriangles {
    std::vector<Vec3> positions;
    std::vector<std::uint32_t> corners;  ///< three for each triangle
    /// Of each position, linear, from 0 to 1; or none.
    std::vector<std::array<float, 3>> colours = {};
};

/// Decodes a mesh that is compressed with Draco (KHR_draco_mesh_compression).
/// @param position  number of the attribute that holds positions, as the document says
/// @param colour  that of colours, which are left out where they cannot be used; negative: none
/// Errors: gltf_invalid, model_too_many_vertices, model_too_many_faces.
Result<GltfTriangles> decode_draco(std::span<const unsigned char> bytes, std::uint32_t position,
                                   int colour, const mesh::ReadMeshOptions& caps);

}  // namespace ossuary::index
