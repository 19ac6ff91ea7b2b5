#pragma once

#include <tiny_gltf.h>

#include <string_view>

#include "engine/core/result.h"
#include "index/reader/companions.h"

namespace ossuary::index {

/// A glTF 2 document with its buffers, from text or a GLB. Images are left out. Files that it
/// refers to are asked for.
/// Errors: gltf_invalid; gltf_buffer for a file that is not there or not given, by its name;
/// gltf_extension for a required extension that changes what is seen and that nothing here knows.
Result<tinygltf::Model> open_gltf(std::string_view bytes, const AskForFile& ask);

}  // namespace ossuary::index
