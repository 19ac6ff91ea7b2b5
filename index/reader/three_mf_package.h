#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace ossuary::index {

/// A 3MF package without the relations that say nothing of the shape.
struct TrimmedPackage {
    std::string bytes;
    std::size_t dropped = 0;  ///< relations
};

/// Leaves out of a package the relations of its root to anything but the model (thumbnails,
/// properties), and those of other parts to print tickets and to what is not there, unless that is
/// of the model as well. Programs leave thumbnails out and their relations in, which lib3mf
/// refuses. None where there is nothing to leave out or the package cannot be written anew.
[[nodiscard]] std::optional<TrimmedPackage> trim_package(std::string_view package);

}  // namespace ossuary::index
