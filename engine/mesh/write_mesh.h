#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "engine/core/result.h"
#include "engine/mesh/triangle_mesh.h"

namespace ossuary::mesh {

/// The mesh as OFF text. Coordinates are written with the fewest digits that read back as the very
/// same doubles; triangles stay triangles.
/// @param colours  of each triangle; none: those of the mesh, as faces' where each triangle has
/// one,
///                 else as vertices' (COFF), where the first triangle at a vertex says its colour
[[nodiscard]] std::string to_off(const TriangleMesh& mesh, std::span<const Colour> colours = {});

/// The mesh as Wavefront OBJ text, in the same precision.
/// @param groups  the number of the group that each triangle is in, or none; each group comes once,
///                by its number, under `name` and that
[[nodiscard]] std::string to_obj(const TriangleMesh& mesh,
                                 std::span<const std::uint32_t> groups = {},
                                 const std::string& name = "group");

/// The mesh as a binary little-endian PLY file, coordinates as doubles.
/// @param colours  as for to_off
[[nodiscard]] std::string to_ply(const TriangleMesh& mesh, std::span<const Colour> colours = {});

/// The mesh as STL, coordinates rounded to floats, normals by the right-hand rule (zero for
/// triangles without area): binary, or text where there are groups, which become solids.
/// @param groups, name  as for to_obj
[[nodiscard]] std::string to_stl(const TriangleMesh& mesh,
                                 std::span<const std::uint32_t> groups = {},
                                 const std::string& name = "group");

/// Writes an OFF file. Errors: file_unwritable.
Result<void> write_off(const TriangleMesh& mesh, const std::filesystem::path& path);

/// Writes an OBJ file. Errors: file_unwritable.
Result<void> write_obj(const TriangleMesh& mesh, const std::filesystem::path& path);

}  // namespace ossuary::mesh
