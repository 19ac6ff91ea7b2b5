#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "engine/core/geometry.h"
#include "engine/core/result.h"
#include "engine/mesh/read_mesh.h"

namespace ossuary::index {

/// How a beam ends (3MF Beam Lattice Extension 1.1, section 2.1).
enum class BeamCap : std::uint8_t {
    kSphere,      ///< a ball around the node
    kHemisphere,  ///< half a ball beyond the node
    kButt,        ///< flat at the node
};

/// A round strut between two nodes, a truncated cone where its radii differ.
struct Beam {
    std::array<std::uint32_t, 2> nodes{};
    std::array<double, 2> radii{};
    std::array<BeamCap, 2> caps{};
};

/// A lattice as a closed surface for each strut and for each ball at a node, which overlap where
/// they meet. Circles are polygons of the same area: of 24 sides, or of fewer (at least 6) where
/// there are so many struts that they would be more than 500,000 triangles. Struts between two
/// nodes in one place leave the balls at their ends alone. Faces are not numbered.
/// Errors: three_mf_invalid (a node that is none, a radius that is not a positive number),
/// model_too_many_vertices, model_too_many_faces (before anything is built).
Result<mesh::TriangleMesh> beam_lattice_surface(std::span<const Vec3> nodes,
                                                std::span<const Beam> beams,
                                                const mesh::ReadMeshOptions& caps);

}  // namespace ossuary::index
