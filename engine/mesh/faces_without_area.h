#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/mesh/triangle_mesh.h"

namespace ossuary::mesh {

/// For each triangle whether it has area (is_degenerate, measures.h, says what has none).
std::vector<std::uint8_t> have_area(const TriangleMesh& mesh);

/// A mesh without the faces that have no area, as far as nothing holds on to them.
struct WithoutEmptyFaces {
    /// Null where every triangle stays, also where none has area: a model of lines is taken as it
    /// is. Vertices and the order of triangles are those of the input.
    std::optional<TriangleMesh> mesh;
    std::size_t removed = 0;  ///< triangles
};

/// Takes out triangles without area. Those stay that close a surface: each of their edges runs
/// along another triangle, and triangles with area use all their corners. A corner of others that
/// are part of a closed surface is drawn to one that triangles with area use, so that what was
/// closed stays closed. A surface may be closed as it is numbered or only where vertices at one
/// place are one.
WithoutEmptyFaces without_empty_faces(const TriangleMesh& mesh);

}  // namespace ossuary::mesh
