#pragma once

#include <cstddef>

#include "engine/mesh/triangle_mesh.h"

namespace ossuary::mesh {

struct OrientResult {
    TriangleMesh mesh;  ///< the same triangles in the same order, some turned over
    std::size_t flipped_triangles = 0;
    /// Edges of two triangles that cannot agree (a Moebius strip has some).
    std::size_t unorientable_edges = 0;
};

/// Makes neighbours across edges of exactly two triangles face the same way, and each patch so
/// connected face outwards: its signed volume about its own centroid is not negative. A mesh whose
/// patches agree and face outwards comes back unchanged.
OrientResult orient(const TriangleMesh& mesh);

}  // namespace ossuary::mesh
