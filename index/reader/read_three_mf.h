#pragma once

#include <string_view>

#include "engine/core/result.h"
#include "engine/mesh/read_mesh.h"

namespace ossuary::index {

/// Reads a 3MF package with lib3mf: the items of its build, each an object, with the components and
/// transforms below them, in the file's unit; z points up. Colours are those of base materials and
/// colour groups.
/// Errors: three_mf_invalid; three_mf_extension for a required extension that nothing here knows,
/// by its name; those of SceneBuilder.
Result<mesh::ReadMeshResult> read_three_mf(std::string_view bytes,
                                           const mesh::ReadMeshOptions& caps);

}  // namespace ossuary::index
