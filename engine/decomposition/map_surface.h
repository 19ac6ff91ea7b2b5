#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "engine/decomposition/segmentation.h"
#include "engine/mesh/triangle_mesh.h"
#include "engine/skeleton/skeleton_graph.h"

namespace ossuary::decomposition {

struct MapSurfaceOptions {
    double sampled = 0.2;    ///< the share of the vertices that eq. 3.9 is asked for
    std::uint64_t seed = 1;  ///< of the choice of them; the same on every machine
};

/// The thesis' decomposition (sec. 3.4): a random share of the surface's vertices is mapped to the
/// branches of the skeleton (branch_mapping.h), the rest flooded from them and the borders refined
/// by curvature (flooding.h), which is how the third criterion of sec. 3.4.1 is read. A triangle
/// takes the branch of most of its corners. Pieces of the surface without a sample are mapped
/// whole.
/// @param mesh      vertices told apart by index: weld a soup first
/// @param skeleton  refined, in the mesh's units; without branches everything maps to 0
/// @returns the branch of each triangle
std::vector<std::uint32_t> map_surface(const mesh::TriangleMesh& mesh,
                                       const skeleton::SkeletonGraph& skeleton,
                                       const MapSurfaceOptions& options = {},
                                       const std::stop_token& stop = {});

}  // namespace ossuary::decomposition
