#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>

#include "engine/core/geometry.h"
#include "engine/mesh/triangle_mesh.h"

namespace ossuary::mesh {

/// What of a mesh stands for the model, and how it lies.
struct Body {
    /// Null where that is the whole mesh. Its vertices are those of the whole, its triangles some
    /// of them in the same order.
    std::optional<TriangleMesh> mesh;
    Mat3 axes = Mat3::Identity();        ///< as columns, orthonormal: those asked for
    std::size_t faces_without_area = 0;  ///< triangles left out for that
    std::size_t pieces_apart = 0;        ///< small pieces left out because they lie apart
    std::size_t triangles_apart = 0;     ///< of those pieces

    [[nodiscard]] const TriangleMesh& of(const TriangleMesh& whole) const {
        return mesh ? *mesh : whole;
    }
};

struct BodyOptions {
    /// The axes to lay the model along; null for its canonical pose (canonical_pose.h).
    std::optional<Mat3> axes;
    /// Pieces hold together over gaps up to this share of the longest side of the box around all
    /// that counts, in [1/48, 1/4].
    double reach = 1.0 / 24;
    /// What lies apart counts from this share of the main piece's longest side; 0 leaves out none.
    double min_extent = 0.1;
    /// Where what lies apart has more than this share of the whole area, it is the model's own.
    double max_area = 0.05;
};

/// Finds what of a mesh counts. Faces without area do not (faces_without_area.h). Nor do specks:
/// small pieces that lie apart at the scale of all that counts. Leaving out some shrinks that
/// scale, so that others may lie apart then; they are looked at again until nothing changes. The
/// main piece, which others are measured by, is the largest by area that holds together at its own
/// scale; whatever is as large as `min_extent` of it counts however far away it is. Many small
/// pieces that are the model, a plate of rice or a chain or leaves, lie near each other, are of
/// like size, or have too much of the area to be specks.
///
/// The choice does not depend on how the model is placed, scaled or numbered, nor turned where the
/// axes turn with it. When `stop` is requested, specks stay.
Body find_body(const TriangleMesh& mesh, const BodyOptions& options = {},
               const std::stop_token& stop = {});

}  // namespace ossuary::mesh
