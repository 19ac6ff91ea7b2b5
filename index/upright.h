#pragma once

#include "engine/mesh/triangle_mesh.h"
#include "index/up.h"

namespace ossuary::index {

/// How much speaks for an axis being a model's vertical, each in [0, 1].
struct UprightEvidence {
    /// Of the model's shadow on the ground, the share that it could rest on: the convex hull of
    /// what lies within 2 % of its size above the lowest point.
    double footprint = 0.0;
    /// How far the model is from being its own mirror image, its top at its bottom: the least share
    /// of the surface without a counterpart, over mirrors near the middle.
    double lopsidedness = 0.0;
};

/// @pre a mesh with triangles and extent
[[nodiscard]] UprightEvidence upright_evidence(const mesh::TriangleMesh& mesh, Up up);

/// The axis, y or z, that more speaks for (the sum of the evidence), or `convention`, one of these,
/// where both speak alike. A guess: see docs/operations.md for how often it is
/// right.
[[nodiscard]] Up find_up(const mesh::TriangleMesh& mesh, Up convention = Up::kY);

}  // namespace ossuary::index
