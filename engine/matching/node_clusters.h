#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ossuary::matching {

/// Connected groups of matched nodes (thesis sec. 3.3.1: the sizes of clusters of matched nodes).
class NodeClusters {
public:
    explicit NodeClusters(std::size_t nodes) : parent_(nodes), matched_(nodes, 0) {
        for (std::size_t i = 0; i < nodes; ++i) parent_[i] = i;
    }
    void add(std::size_t node) { matched_[node] = 1; }
    /// @pre both have been added
    void join(std::size_t a, std::size_t b) { parent_[root(a)] = root(b); }
    /// Number of added nodes in each group, largest first.
    [[nodiscard]] std::vector<std::uint32_t> sizes() const;

private:
    [[nodiscard]] std::size_t root(std::size_t node) const {
        while (parent_[node] != node) node = parent_[node];
        return node;
    }
    std::vector<std::size_t> parent_;
    std::vector<char> matched_;
};

}  // namespace ossuary::matching
