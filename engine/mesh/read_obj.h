#pragma once

#include <stop_token>
#include <string_view>

#include "engine/core/result.h"
#include "engine/mesh/read_mesh.h"

namespace ossuary::mesh {

/// Whether most of the first lines begin with a word of OBJ files; comments do not count.
[[nodiscard]] bool looks_like_obj(std::string_view text);

/// Reads a Wavefront OBJ file (Object Files, appendix B1 of the Advanced Visualizer's manual);
/// `name` stands for the file in messages. All objects and groups are one mesh;
/// its objects are those of the file, or its groups where it has no objects. `usemtl` says which
/// material triangles have; whose colours they are another file says (obj_materials.h).
///
/// Taken: `v` with whatever follows three coordinates: one number (w) is skipped, three or
/// four are a colour; `f` with any number of corners,
/// each an index, alone or with those of texture coordinates and normals, which are skipped (`7`,
/// `7/`, `7//2`, `7/1/2`); indices that count back from the last vertex; faces before the vertices
/// that they name; lines that go on after `\`; comments; LF, CR LF and lone CR. Vertices are kept
/// as they are, used or not.
///
/// Errors, with the line: obj_binary (a NUL byte); obj_truncated (a line ends early);
/// obj_bad_number; obj_non_finite; mesh_scale; obj_index_out_of_range; obj_too_many_vertices,
/// obj_too_many_faces, obj_too_many_corners; cancelled.
///
/// Warnings: faces_under_three_corners, polygons_without_ears; lines_and_points_skipped (`l`, `p`),
/// free_form_skipped (curves and curved surfaces), unknown_lines.
Result<ReadMeshResult> read_obj(std::string_view text, std::string_view name,
                                const ReadMeshOptions& options = {},
                                const std::stop_token& stop = {});

}  // namespace ossuary::mesh
