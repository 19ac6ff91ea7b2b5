#pragma once

#include <vector>

#include "engine/mesh/nearest_triangle.h"
#include "engine/registration/axis_candidates.h"
#include "engine/registration/local_features.h"
#include "engine/registration/similarity.h"
#include "engine/registration/surface_distance.h"
#include "engine/registration/surface_points.h"

namespace ossuary::registration {

/// A mesh with all that aligning it and measuring distances from it needs, made once.
class Shape {
public:
    /// @pre the mesh has area, and outlives this
    explicit Shape(const mesh::TriangleMesh& mesh, const SurfacePointsOptions& options = {});

    [[nodiscard]] const mesh::TriangleMesh& mesh() const { return *mesh_; }
    [[nodiscard]] const SurfacePoints& surface() const { return surface_; }
    [[nodiscard]] const NearestPoint& nearest() const { return nearest_; }
    [[nodiscard]] const mesh::NearestTriangle& triangles() const { return triangles_; }

private:
    const mesh::TriangleMesh* mesh_;
    SurfacePoints surface_;
    NearestPoint nearest_;
    mesh::NearestTriangle triangles_;
};

/// How near two surfaces are to each other once one is placed in the other.
struct SurfaceAgreement {
    double mean = 0.0;  ///< % of the target's diagonal; the greater of the two ways, as below
    double most = 0.0;  ///< what 95 % of the points keep within
    double greatest = 0.0;
    double source_explained = 0.0;  ///< shares of the area within .5 % of the diagonal
    double target_explained = 0.0;
};

struct Alignment {
    Similarity placement;  ///< of the source in the target
    SurfaceAgreement agreement;
};

/// Both ways, by the exact triangles on one side and the points on the other.
[[nodiscard]] SurfaceAgreement agreement(const Shape& source, const Shape& target,
                                         const Similarity& placement);

/// Lays one surface onto the whole of another as well as it can: candidates from the principal axes
/// and, where none of these is good, from local features; the best few are refined by iterated
/// closest points, and the one with the least mean distance both ways wins. Deterministic.
[[nodiscard]] Alignment align(const Shape& source, const Shape& target,
                              const MotionKind& kind = {});

}  // namespace ossuary::registration
