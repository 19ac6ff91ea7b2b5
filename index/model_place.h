#pragma once

#include <filesystem>
#include <string>

namespace ossuary::index {

/// Where a model is: a file, and which part of it where that holds several ("parts.zip#arm.stl":
/// the member arm.stl of parts.zip). The index keeps both as one path.
struct ModelPlace {
    std::filesystem::path file;
    std::string within;  ///< empty = all of the file

    /// What classifications name, and names come from: the file's own name, or the member's.
    [[nodiscard]] std::filesystem::path file_name() const;
};

/// A path that names a file that exists stands for that, whatever is in its name; else what follows
/// a model file's name (mesh::is_model_file) and `#` lies within it.
[[nodiscard]] ModelPlace place_of(const std::filesystem::path& path);

/// The other way round.
[[nodiscard]] std::filesystem::path path_of(const ModelPlace& place);

}  // namespace ossuary::index
