#include "engine/matching/tree_shape.h"

#include <cassert>

namespace ossuary::matching {

TreeShape tree_shape(std::span<const std::uint32_t> parents) {
    TreeShape shape;
    if (parents.empty()) return shape;
    const std::size_t count = parents.size();
    shape.child_begin.assign(count + 1, 0);
    for (std::size_t i = 0; i + 1 < count; ++i) {
        assert(parents[i] > i && parents[i] < count);
        ++shape.child_begin[parents[i] + 1];
    }
    for (std::size_t i = 0; i < count; ++i) shape.child_begin[i + 1] += shape.child_begin[i];
    shape.child_nodes.resize(count - 1);
    std::vector<std::uint32_t> next(shape.child_begin.begin(), shape.child_begin.end() - 1);
    for (std::size_t i = 0; i + 1 < count; ++i) {
        shape.child_nodes[next[parents[i]]++] = static_cast<std::uint32_t>(i);
    }
    return shape;
}

TreeShape tree_shape(const std::vector<std::vector<std::uint32_t>>& children) {
    TreeShape shape;
    shape.child_begin.push_back(0);
    for (std::size_t i = 0; i < children.size(); ++i) {
        for (const std::uint32_t child : children[i]) {
            assert(child < i);
            shape.child_nodes.push_back(child);
        }
        shape.child_begin.push_back(static_cast<std::uint32_t>(shape.child_nodes.size()));
    }
    return shape;
}

}  // namespace ossuary::matching
