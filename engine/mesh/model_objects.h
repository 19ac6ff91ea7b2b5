#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/mesh/read_mesh.h"

namespace ossuary::mesh {

/// Where an object of a file begins, as a reader comes to it.
struct ObjectMark {
    std::string name;
    std::uint32_t first_face = 0;
};

/// The objects between marks, as runs of a mesh's triangles; those without triangles are left out,
/// and what comes before the first mark is an object without a name.
/// @param marks  by ascending first face
[[nodiscard]] std::vector<ModelObject> objects_between(const std::vector<ObjectMark>& marks,
                                                       const TriangleMesh& mesh);

/// A name for each object by which it can be asked for: UTF-8 without control characters, `object
/// 3` where it has none, and ` (2)` after the second of a name.
[[nodiscard]] std::vector<std::string> object_names(const std::vector<ModelObject>& objects);

/// An object as if the file held nothing else: its triangles, the vertices that these use in their
/// order, and its faces, numbered from 0.
[[nodiscard]] TriangleMesh object_mesh(const TriangleMesh& mesh, const ModelObject& object);

}  // namespace ossuary::mesh
