#pragma once

#include <filesystem>
#include <string>

#include "engine/core/result.h"
#include "engine/mesh/triangle_mesh.h"

namespace ossuary::mesh {

/// The mesh as OFF text. Coordinates are written with the fewest digits that read back as the very
/// same doubles; triangles stay triangles.
[[nodiscard]] std::string to_off(const TriangleMesh& mesh);

/// The mesh as Wavefront OBJ text, in the same precision.
[[nodiscard]] std::string to_obj(const TriangleMesh& mesh);

/// Writes an OFF file. Errors: file_unwritable.
Result<void> write_off(const TriangleMesh& mesh, const std::filesystem::path& path);

/// Writes an OBJ file. Errors: file_unwritable.
Result<void> write_obj(const TriangleMesh& mesh, const std::filesystem::path& path);

}  // namespace ossuary::mesh
