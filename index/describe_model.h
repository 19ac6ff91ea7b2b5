#pragma once

#include <stop_token>
#include <string_view>

#include "engine/core/result.h"
#include "index/model.h"

namespace ossuary::index {

/// From a model file's bytes to all that an index keeps of it; `name` stands for the file in
/// messages. The summary's path, name and class are left to the caller.
/// Errors: those of read_mesh and describe, out_of_memory, internal; never an exception.
Result<NewModel> describe_model(std::string_view bytes, std::string_view name,
                                const IndexParameters& parameters, std::stop_token stop = {});

/// The mesh as viewers are given it.
[[nodiscard]] PreviewMesh make_preview(const TriangleMesh& mesh);

}  // namespace ossuary::index
