#pragma once

#include <string_view>

#include "engine/core/result.h"
#include "engine/mesh/read_mesh.h"
#include "engine/mesh/recognise_format.h"

namespace ossuary::index {

/// How far triangles may lie from the surfaces of a CAD model, by the diagonal of the box around
/// it, and the angle between neighbouring ones in radians.
inline constexpr double kCadDeviation = 1e-3;
inline constexpr double kCadAngle = 0.3;

/// STEP (AP203, AP214, AP242) and IGES by OpenCASCADE: all roots, cut into triangles, in
/// millimetres; each solid is an object (of STEP with the name of its entity), and so is what lies
/// in none.
/// Errors: scene_invalid; model_…; format_unsupported in ossuary-read (no_cad.cpp).
Result<mesh::ReadMeshResult> read_cad(std::string_view bytes, mesh::ModelFormat format,
                                      const mesh::ReadMeshOptions& caps);

}  // namespace ossuary::index
