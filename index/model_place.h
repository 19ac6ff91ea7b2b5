#pragma once

#include <filesystem>
#include <string>

namespace ossuary::index {

/// Where a model is: a file, a member of it where it is an archive, and one object of these where
/// it is not the whole. The index keeps all as one path: `parts.zip#arms/left.stl`,
/// `plate.3mf#Wheel`, `toys.zip#car.glb#Wheel`.
struct ModelPlace {
    std::filesystem::path file;
    std::string member;  ///< of a ZIP archive; empty = none
    std::string object;  ///< empty = all that is there

    /// What classifications name: the file's own name, or the member's.
    [[nodiscard]] std::filesystem::path file_name() const;
    /// What people call the model: the object, or the file's name without its extension.
    [[nodiscard]] std::string name() const;
};

/// A path that names a file that exists stands for that, whatever is in its name; else what follows
/// a model file's name (mesh::is_model_file) and `#` lies within it.
[[nodiscard]] ModelPlace place_of(const std::filesystem::path& path);

/// The other way round.
[[nodiscard]] std::filesystem::path path_of(const ModelPlace& place);

/// Whether a file's name is that of a ZIP archive (any case).
[[nodiscard]] bool is_archive_name(const std::filesystem::path& path);

}  // namespace ossuary::index
