#pragma once

#include <filesystem>
#include <stop_token>
#include <string_view>

#include "engine/core/result.h"
#include "engine/mesh/read_mesh.h"
#include "engine/voxel/volume_surface.h"
#include "engine/voxel/wrap_points.h"

namespace ossuary::voxel {

struct ReadModelOptions {
    mesh::ReadMeshOptions mesh = {};
    WrapOptions wrap = {};
    InsideOptions inside = {};  ///< of volumes; other files have no use for it
};

/// Reads whatever may be a model as a mesh, by its contents: what read_mesh takes; of files that
/// hold points and no face, the surface that the points lie on (wrap_points.h; warning
/// points_wrapped, and stray_points where some were left out); of volumes, the surface of what is
/// inside (volume.h, volume_surface.h). Each may be packed as gzip data.
/// Errors: those of read_mesh, wrap_points, gunzip, read_volume and volume_surface.
Result<mesh::ReadMeshResult> read_model(const std::filesystem::path& path,
                                        const ReadModelOptions& options = {},
                                        const std::stop_token& stop = {});

/// The same from memory; `name` stands for the file in messages.
Result<mesh::ReadMeshResult> read_model(std::string_view bytes, std::string_view name,
                                        const ReadModelOptions& options = {},
                                        const std::stop_token& stop = {});

}  // namespace ossuary::voxel
