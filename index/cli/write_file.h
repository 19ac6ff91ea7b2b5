#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "engine/core/result.h"
#include "engine/skeleton/skeleton_graph.h"

namespace ossuary::cli {

/// Writes a whole file. Errors: file_unwritable.
Result<void> write_file(const std::filesystem::path& path, std::string_view bytes);

/// A skeleton as Wavefront .obj polylines, one `l` a branch, in the graph's unit.
[[nodiscard]] std::string wavefront_lines(const skeleton::SkeletonGraph& graph);

}  // namespace ossuary::cli
