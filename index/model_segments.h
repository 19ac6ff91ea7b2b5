#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/decomposition/decompose.h"
#include "index/model.h"

namespace ossuary::index {

/// The parts of a model's preview mesh.
struct ModelSegments {
    /// The branches are those of the stored skeleton.
    std::vector<Decomposition::Part> parts;
    std::vector<std::uint32_t> labels;  ///< the part of each triangle of the preview
};

/// Cuts the preview of an indexed model into parts (some 40 ms) and names for each the branch of
/// the stored skeleton that most of its area is mapped to (thesis eq. 3.9; branch_mapping.h).
/// Errors: those of decompose.
Result<ModelSegments> model_segments(const PreviewMesh& preview, const SkeletonGraph& skeleton,
                                     std::stop_token stop = {});

/// The preview of an indexed model, its parts and the stored skeleton as a rigged glTF file
/// (gltf.h).
/// Errors: those of decompose.
Result<std::string> model_rig(const PreviewMesh& preview, const SkeletonGraph& skeleton,
                              std::string_view name, std::stop_token stop = {});

/// {parts: [{part, colour, triangles, area, area_share, branch, neighbors}], labels}
[[nodiscard]] nlohmann::json to_json(const ModelSegments& segments);

}  // namespace ossuary::index
