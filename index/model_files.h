#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/ranking/classification.h"

namespace ossuary::index {

/// The absolute, normalised form in which an index keeps paths (links are not followed).
[[nodiscard]] std::filesystem::path index_path(const std::filesystem::path& path);

/// All files that `paths` name, as index_path, sorted by their bytes and without repetition: files
/// as they are, folders with all the model files below them. Folders that cannot be read are left
/// out, as are links to folders. Errors: file_not_found for a path that does not exist.
Result<std::vector<std::filesystem::path>> find_model_files(
    const std::vector<std::filesystem::path>& paths);

/// True when `path` is one of `roots` or lies below one; all as index_path.
[[nodiscard]] bool is_under(const std::filesystem::path& path,
                            const std::vector<std::filesystem::path>& roots);

/// Bytes of a whole file. Errors: file_not_found, file_unreadable, file_too_large.
Result<std::string> read_bytes(const std::filesystem::path& path, std::uint64_t max_bytes);

/// Class of each file name that a classification names. An id stands for the first of its candidate
/// names that is among `files`.
[[nodiscard]] std::map<std::string, std::string> classes_by_file_name(
    const ranking::Classification& classification, const std::vector<std::filesystem::path>& files);

}  // namespace ossuary::index
