#pragma once

#include <nlohmann/json.hpp>
#include <stop_token>
#include <string>
#include <string_view>

#include "engine/core/result.h"
#include "engine/mesh/triangle_mesh.h"
#include "index/model.h"

namespace ossuary::index {

/// Cuts a model into the parts that people would see (decompose with its defaults, as `ossuary
/// segment` does) and carries them over to its preview (carry_labels.h). Each part has the branch
/// of the stored skeleton that most of its area on the preview is mapped to (thesis eq. 3.9;
/// branch_mapping.h).
/// @param preview  a coarse copy of `mesh`, at full precision (decimate.h)
/// @param skeleton  refined, in model units
/// Errors: those of decompose and carry_labels.
Result<ModelSegments> segment_model(const mesh::TriangleMesh& mesh,
                                    const mesh::TriangleMesh& preview,
                                    const skeleton::SkeletonGraph& skeleton,
                                    std::stop_token stop = {});

/// The preview of an indexed model, its parts and the stored skeleton as a rigged glTF file
/// (gltf.h).
/// Errors: index_corrupt when the parts are those of another preview, cancelled.
Result<std::string> model_rig(const PreviewMesh& preview, const ModelSegments& segments,
                              const skeleton::SkeletonGraph& skeleton, std::string_view name,
                              const std::stop_token& stop = {});

/// A mesh with its parts as a rigged glTF file at its own resolution.
/// @param decomposition  of `mesh`
/// Errors: cancelled.
Result<std::string> mesh_rig(const mesh::TriangleMesh& mesh,
                             const decomposition::Decomposition& decomposition,
                             std::string_view name, const std::stop_token& stop = {});

/// {parts: [{part, colour, triangles, area, area_share, branch, neighbors}], labels}
[[nodiscard]] nlohmann::json to_json(const ModelSegments& segments);

}  // namespace ossuary::index
