#pragma once

#include <cstdint>
#include <vector>

#include "engine/decomposition/vertex_graph.h"

namespace ossuary::decomposition {

inline constexpr std::uint32_t kUnlabeled = 0xFFFFFFFFU;

/// Floods labels over a surface from the vertices that have one, a ring at a time (thesis sec.
/// 3.4.1, after the watershed transform): a vertex takes its labelled neighbours' label; where they
/// disagree, that of the one whose normal is closest to its own. Vertices that no label can reach
/// stay kUnlabeled.
void flood_labels(const VertexGraph& surface, std::vector<std::uint32_t>& labels);

struct CurvatureConsistencyOptions {
    double bandwidth = 2.0;  ///< of curvature times the square root of the area
    int rounds = 3;
};

/// Refines the borders between labels by mean shift (Comaniciu and Meer, 2002) of curvature (thesis
/// sec. 3.4.1): the curvature of a vertex on a border moves to the mode of the curvatures within
/// two edges of it, and the vertex takes the label of most of those vertices that are near the
/// mode.
void refine_by_curvature(const VertexGraph& surface, std::vector<std::uint32_t>& labels,
                         const CurvatureConsistencyOptions& options = {});

}  // namespace ossuary::decomposition
