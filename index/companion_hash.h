#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "index/model_reader.h"

namespace ossuary::index {

/// The files that a glTF document (text or binary) refers to for its numbers, as it names them,
/// each once: all but images and data within the document; those that an OBJ file may mean by its
/// material libraries (mesh::material_libraries). None of other files.
[[nodiscard]] std::vector<std::string> referred_files(std::string_view bytes);

/// content_hash of a file together with those that it refers to, so that it changes when one of
/// them does, goes or comes; its own hash where it refers to none or `companions` is empty.
[[nodiscard]] std::string hash_with_companions(std::string_view bytes,
                                               const Companions& companions);

/// All of a file that a model refers to. Errors: file_unreadable.
[[nodiscard]] Result<WholeFile> read_companion(const OwnedDescriptor& file);

}  // namespace ossuary::index
