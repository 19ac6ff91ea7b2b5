#pragma once

#include <stop_token>
#include <string_view>

#include "engine/core/result.h"
#include "engine/mesh/read_mesh.h"

namespace ossuary::mesh {

/// Reads the text of an OFF file (the Geomview manual, "OFF: Object File Format") and its
/// relatives COFF, NOFF, STOFF and their combinations; `name` stands for the file in messages.
///
/// Taken: a byte order mark; LF, CR LF and lone CR; comments anywhere; counts on the line of the
/// header word or glued to it (`OFF3 1 0`); the header word in any case, or none at all, which the
/// format allows; no edge count; braces of OOGL around it all, and what OOGL allows before the
/// word; a fourth coordinate (4OFF), which divides the others; OFF BINARY (read_off_binary.h). One
/// vertex and one face a line, the rest of the line being normals, texture coordinates, which are
/// skipped, or colours; where the lines do not fit, the text is read as a free sequence of numbers
/// instead, provided that it comes out even. Polygons are triangulated. Faces of any shape are
/// kept, those with fewer than three corners give no triangle.
///
/// Refused, naming the line, what was expected and what was found: off_header; off_binary (NUL
/// bytes in text, data of no known layout); off_dimension (nOFF other than 3); off_counts;
/// off_too_many_vertices, off_too_many_faces, off_too_many_corners (over the caps, before anything
/// is allocated); off_truncated (the file or a line ends early); off_bad_number; off_non_finite
/// (nan, inf, or beyond doubles); mesh_scale (beyond `max_coordinate`); off_index_out_of_range;
/// cancelled.
///
/// Warnings: header_missing, edge_count_missing, unannounced_vertex_values, free_form_lines,
/// faces_under_three_corners, polygons_without_ears, trailing_text. What is odd about the surface
/// itself is said by surface_warnings (inspect.h), which read_mesh adds.
///
/// Memory: never more than a small multiple of the text, whatever the counts say.
Result<ReadMeshResult> read_off(std::string_view text, std::string_view name,
                                const ReadMeshOptions& options = {},
                                const std::stop_token& stop = {});

}  // namespace ossuary::mesh
