#pragma once

#include <stop_token>
#include <string_view>

#include "engine/core/result.h"
#include "engine/mesh/read_mesh.h"

namespace ossuary::mesh {

/// Whether the first lines each begin with three numbers; a first line with nothing but a count,
/// and comments after `#` or `//`, may precede them.
[[nodiscard]] bool looks_like_xyz(std::string_view text);

/// Whether text that begins with three counts, as OFF does without its word, is a list of points
/// with whole coordinates: all lines are of three numbers, and not as many as the counts ask for.
[[nodiscard]] bool is_xyz_rather_than_off(std::string_view text);

/// Reads points as text (XYZ, ASC, PTS): three coordinates a line, then whatever else there is,
/// which is skipped; comments after `#`, and lines that begin with `//`; the number of points may
/// stand alone on the first line. `name` stands for the file in messages. The mesh has no faces.
///
/// Errors, with the line: xyz_truncated (fewer than three numbers); xyz_bad_number; xyz_non_finite;
/// mesh_scale; xyz_too_many_points (over max_vertices); cancelled. Warnings: point_count_differs.
Result<ReadMeshResult> read_xyz(std::string_view text, std::string_view name,
                                const ReadMeshOptions& options = {},
                                const std::stop_token& stop = {});

}  // namespace ossuary::mesh
