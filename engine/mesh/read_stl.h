#pragma once

#include <stop_token>
#include <string_view>

#include "engine/core/result.h"
#include "engine/mesh/read_mesh.h"

namespace ossuary::mesh {

/// Whether bytes are a binary STL file by their size: an 80-byte header with anything in it, a
/// count and 50 bytes a triangle, to the end. Said before any word is looked at: many binary files
/// begin with `solid`.
[[nodiscard]] bool is_binary_stl(std::string_view bytes);

/// The same for bytes that go on after the last triangle or end before it; true only where they
/// cannot be text and the first triangles have usable corners.
[[nodiscard]] bool resembles_binary_stl(std::string_view bytes);

/// Whether text begins as STL does: `solid` and, soon, `facet` or `endsolid`; or `facet normal`.
[[nodiscard]] bool looks_like_stl_text(std::string_view text);

/// Reads an STL file, text or binary (3D Systems, StereoLithography Interface Specification, 1989);
/// `name` stands for the file in messages. Corners at equal positions become one vertex; vertices
/// are in the order of first use. Normals are skipped, colours are those of binary files
/// (stl_colours.h).
///
/// Text: words in any case, any blanks and line ends, comments after `#`, several solids, facets
/// without a normal, loops of more than three corners, no triangle at all.
///
/// Errors, with the line or the triangle: stl_syntax; stl_truncated; stl_bad_number;
/// stl_non_finite; mesh_scale; stl_too_many_vertices, stl_too_many_faces, stl_too_many_corners;
/// cancelled.
///
/// Warnings: trailing_bytes, trailing_text, end_missing, faces_under_three_corners,
/// polygons_without_ears.
Result<ReadMeshResult> read_stl(std::string_view bytes, std::string_view name,
                                const ReadMeshOptions& options = {},
                                const std::stop_token& stop = {});

}  // namespace ossuary::mesh
