#pragma once

#include "engine/mesh/triangle_mesh.h"
#include "index/model.h"

namespace ossuary::index {

/// A mesh as viewers are given it.
[[nodiscard]] PreviewMesh make_preview(const mesh::TriangleMesh& coarse);

/// A preview as a mesh, each triangle a face.
[[nodiscard]] mesh::TriangleMesh mesh_of(const PreviewMesh& preview);

}  // namespace ossuary::index
