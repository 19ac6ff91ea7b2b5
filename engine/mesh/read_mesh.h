#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/mesh/triangle_mesh.h"

namespace ossuary::mesh {

/// Caps that keep a hostile or broken file from taking the machine.
struct ReadMeshOptions {
    std::uint64_t max_bytes = 256u << 20;
    std::uint32_t max_vertices = 5'000'000;
    std::uint32_t max_faces = 10'000'000;
    std::uint32_t max_face_corners = 10'000;
    std::uint32_t max_triangles = 20'000'000;  ///< after triangulation
    /// Larger magnitudes and smaller models are refused: results are kept and sent as floats, which
    /// end at 3.4e38 and 1.2e-38.
    double max_coordinate = 1e30;
    double min_extent = 1e-30;  ///< of the longest side of the box around the faces with area
};

/// The axis that points up where a format says or means one.
enum class UpAxis { kX, kY, kZ };

/// A piece of a model file that the file tells from others, placed as there: a run of the mesh's
/// triangles (model_objects.h).
struct ModelObject {
    std::string name;  ///< any bytes; empty where the file has none
    std::uint32_t first_triangle = 0;
    std::uint32_t triangles = 0;
};

struct ReadMeshResult {
    TriangleMesh mesh;
    std::vector<MeshWarning> warnings;
    double metres_per_unit = 0.0;  ///< 0 where neither file nor format says it
    std::optional<UpAxis> up = std::nullopt;
    /// In their order, of formats that have them: 3MF, glTF, COLLADA, X3D, AMF, FBX, STEP, IGES,
    /// OBJ, STL as text.
    std::vector<ModelObject> objects = {};
    /// What triangles are made of, in their order, where an OBJ file says it (`usemtl`).
    std::vector<ModelObject> materials = {};
};

/// Reads a model file; the format follows its contents, not its name: OFF and relatives, STL, OBJ,
/// PLY, points as text. What is odd about the surface but does not keep it from being used comes
/// back as warnings. Errors: file_not_found, file_unreadable, file_too_large, format_unsupported
/// (the message names the format that was recognised), format_unknown, and those of the format's
/// own reader (read_off.h, read_stl.h, read_obj.h, read_ply.h, read_xyz.h); mesh_scale (coordinates
/// or an extent beyond the options' limits); cancelled. A file that holds no face is no error, nor
/// is one whose faces are all in one place.
Result<ReadMeshResult> read_mesh(const std::filesystem::path& path,
                                 const ReadMeshOptions& options = {},
                                 const std::stop_token& stop = {});

/// The same from memory; `name` stands for the file in messages.
Result<ReadMeshResult> read_mesh(std::string_view bytes, std::string_view name,
                                 const ReadMeshOptions& options = {},
                                 const std::stop_token& stop = {});

/// What stands at the end of reading any format: looks at the extent and adds warnings of the
/// surface. Errors: mesh_scale, cancelled.
Result<ReadMeshResult> finish_reading(ReadMeshResult read, std::string_view name,
                                      const ReadMeshOptions& options = {},
                                      const std::stop_token& stop = {});

/// True for file names that the indexer should pick up in a folder: by extension, in any case, with
/// or without `.gz` after it; those of volumes (engine/voxel/volume.h) and ZIP archives too.
[[nodiscard]] bool is_model_file(const std::filesystem::path& path);

}  // namespace ossuary::mesh
