#pragma once

#include <string>

#include "engine/skeleton/skeleton_graph.h"

namespace ossuary::cli {

/// A skeleton as Wavefront .obj polylines, one `l` a branch, in the graph's unit.
[[nodiscard]] std::string wavefront_lines(const skeleton::SkeletonGraph& graph);

}  // namespace ossuary::cli
