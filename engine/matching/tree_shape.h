#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ossuary::matching {

/// A rooted tree with its nodes numbered children before parents, the root the last; or several
/// rooted trees that share subtrees.
struct TreeShape {
    std::vector<std::uint32_t> child_begin;  ///< one more than nodes; into `child_nodes`
    std::vector<std::uint32_t> child_nodes;

    [[nodiscard]] std::size_t size() const {
        return child_begin.empty() ? 0 : child_begin.size() - 1;
    }
    [[nodiscard]] std::span<const std::uint32_t> children(std::size_t node) const {
        return {child_nodes.data() + child_begin[node],
                static_cast<std::size_t>(child_begin[node + 1] - child_begin[node])};
    }
};

/// @param parents  of each node, greater than the node itself; the last entry is ignored
[[nodiscard]] TreeShape tree_shape(std::span<const std::uint32_t> parents);

/// @param children  of each node, each less than the node itself
[[nodiscard]] TreeShape tree_shape(const std::vector<std::vector<std::uint32_t>>& children);

}  // namespace ossuary::matching
