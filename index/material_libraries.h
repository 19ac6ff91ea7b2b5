#pragma once

#include <string_view>

#include "engine/mesh/read_mesh.h"
#include "index/model_reader.h"

namespace ossuary::index {

/// Gives a model that was read from an OBJ file the colours that its material libraries say
/// (mesh::colour_by_materials). Where there is none of them it stays as it is and is warned of:
/// material_library_missing. A file that stands alone, as one that is uploaded, has none.
/// @param obj  the file
void colour_by_libraries(mesh::ReadMeshResult& read, std::string_view obj,
                         const Companions& companions);

}  // namespace ossuary::index
