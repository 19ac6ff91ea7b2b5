#pragma once

#include <stop_token>
#include <string_view>

#include "engine/core/result.h"
#include "engine/mesh/read_mesh.h"

namespace ossuary::mesh {

/// Reads a PLY file (Turk, The PLY Polygon File Format, 1994), text or binary in either byte order;
/// `name` stands for the file in messages.
///
/// Taken, as the header describes it: x, y and z of `vertex`, of any type; the list
/// `vertex_indices` or `vertex_index` of `face`, with counts and indices of any type; triangle
/// strips, the list of the same name of `tristrips`, where a negative number begins the next strip
/// and a triangle that names a vertex twice only links two parts; `red`, `green` and `blue`, also
/// with `diffuse_` before them, of vertices, else of faces. All other elements, properties
/// and lists are skipped, wherever they stand. Polygons are triangulated.
///
/// Errors, with the line or the byte: ply_header (also for an element of faces or vertices that
/// lacks what is read of it); ply_truncated; ply_bad_number; ply_non_finite; mesh_scale;
/// ply_index_out_of_range; ply_too_many_vertices, ply_too_many_faces, ply_too_many_corners;
/// cancelled.
///
/// Warnings: faces_under_three_corners, polygons_without_ears, trailing_bytes, trailing_text.
Result<ReadMeshResult> read_ply(std::string_view bytes, std::string_view name,
                                const ReadMeshOptions& options = {},
                                const std::stop_token& stop = {});

}  // namespace ossuary::mesh
