#pragma once

#include <string_view>

#include "engine/core/result.h"
#include "engine/mesh/mesh_builder.h"
#include "engine/mesh/off_header.h"

namespace ossuary::mesh {

/// Reads the data of a binary OFF file, which begin after the line of the words OFF BINARY. Two
/// layouts exist, and no word tells them apart; taken is the one that comes out even:
/// Geomview's (the manual, "OFF: Object File Format"): big-endian, the number of colour values in
/// each face; OpenMesh's: little-endian, three, four or no colour values in all faces alike.
/// Colours that the header word announces may be those of vertices or of faces.
///
/// Messages do not name the file. Errors: off_binary where neither layout fits; off_dimension;
/// off_index_out_of_range, off_non_finite, mesh_scale; the caps' codes; cancelled.
Result<ReadMeshResult> read_off_binary(std::string_view data, const OffHeader& header,
                                       MeshBuilder builder);

}  // namespace ossuary::mesh
