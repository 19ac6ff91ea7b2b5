#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ossuary::index {

/// The folders that the models of an index lie in, found from their paths: the deepest folder above
/// all of them, or one for each part of the machine where that would be the root itself. By them a
/// model is told from its namesakes without saying where on the machine it lies.
class ModelRoots {
public:
    ModelRoots() = default;
    explicit ModelRoots(std::span<const std::string> paths);

    /// `chairs/armchair.off` below the root; below one of several roots with that root's name in
    /// front. The file's name alone for a path below none of them; empty for an empty one.
    [[nodiscard]] std::string relative(std::string_view path) const;

private:
    std::vector<std::string> roots_;  ///< longest first, each with a slash at its end
};

}  // namespace ossuary::index
