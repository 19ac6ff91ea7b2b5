#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "engine/mesh/read_mesh.h"

namespace ossuary::mesh {

/// Colours of materials by their names.
using MaterialColours = std::map<std::string, Colour, std::less<>>;

/// The diffuse colours (`Kd` with numbers from 0 to 1) of the materials of a library (Wavefront
/// MTL, the Advanced Visualizer's manual, chapter 5). All else is passed over, as are numbers that
/// make no colour: no text is an error.
[[nodiscard]] MaterialColours read_material_colours(std::string_view library);

/// The files that may be the libraries that an OBJ file names (`mtllib`), in their order, each
/// once, with `/` where it has `\`. What stands on one line is the name of one file or of several,
/// which only the files can tell: both come back.
[[nodiscard]] std::vector<std::string> material_libraries(std::string_view obj);

/// Colours the triangles of a model that says which material each has, and has no colours of its
/// own. Those without one, or whose material is not known, are plain; where none is known, or all
/// are white, the model stays without colours.
void colour_by_materials(ReadMeshResult& model, const MaterialColours& colours);

}  // namespace ossuary::mesh
