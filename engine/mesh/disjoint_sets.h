#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ossuary::mesh {

/// Union-find whose representative is always the smallest member, so that results do not depend on
/// the order of the unions.
class DisjointSets {
public:
    explicit DisjointSets(std::size_t count) {
        parent_.reserve(count);
        for (std::uint32_t item = 0; item < count; ++item) parent_.push_back(item);
    }

    /// @param parents  for each item itself or a smaller one of the same set
    explicit DisjointSets(std::vector<std::uint32_t> parents) : parent_(std::move(parents)) {}

    /// One item more, in a set of its own.
    std::uint32_t add() {
        parent_.push_back(static_cast<std::uint32_t>(parent_.size()));
        return parent_.back();
    }

    std::uint32_t find(std::uint32_t item) {
        while (parent_[item] != item) {
            parent_[item] = parent_[parent_[item]];
            item = parent_[item];
        }
        return item;
    }

    void unite(std::uint32_t a, std::uint32_t b) {
        if (parent_[a] == parent_[b]) return;  // most often so where neighbours come in turn
        a = find(a);
        b = find(b);
        if (a < b) {
            parent_[b] = a;
        } else {
            parent_[a] = b;
        }
    }

    /// The representative of every item, in one pass.
    [[nodiscard]] std::vector<std::uint32_t> representatives() const {
        std::vector<std::uint32_t> result(parent_);
        for (std::uint32_t& parent : result) parent = result[parent];  // parents come first
        return result;
    }

private:
    std::vector<std::uint32_t> parent_;
};

}  // namespace ossuary::mesh
