#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/mesh/triangle_mesh.h"

namespace ossuary::mesh {

/// What hangs together across edges of exactly two triangles.
struct OrientedPatch {
    std::size_t triangles = 0;
    std::size_t turned = 0;  ///< of them
    Box3 bounds;
    bool closed = false;  ///< every edge has two triangles, which agree
    /// Its shape says which way is outwards; else (flat ones) a convention does.
    bool sure = false;
};

struct OrientResult {
    TriangleMesh mesh;                   ///< the same triangles in the same order, some turned over
    std::vector<std::uint8_t> turned;    ///< of each triangle
    std::vector<OrientedPatch> patches;  ///< numbered by their first triangle
    std::vector<std::uint32_t> patch_of;  ///< of each triangle
    std::size_t flipped_triangles = 0;
    /// Edges of two triangles that cannot agree (a Moebius strip has some).
    std::size_t unorientable_edges = 0;
};

/// Makes neighbours across edges of exactly two triangles face the same way, and each patch so
/// connected face outwards: its signed volume about its own centroid is positive. Where that says
/// nothing, as of flat patches, they face away from the surface's centroid, else along the first
/// axis that they are not perpendicular to. Patches end where other than two triangles meet. Which
/// way a triangle came makes no difference. A mesh whose patches agree and face outwards comes back
/// unchanged.
OrientResult orient(const TriangleMesh& mesh);

}  // namespace ossuary::mesh
