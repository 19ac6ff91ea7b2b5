#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ossuary {

/// Union-find whose representative is always the smallest member, so that results do not depend on
/// the order of the unions.
class DisjointSets {
public:
    explicit DisjointSets(std::size_t count) {
        parent_.reserve(count);
        for (std::uint32_t item = 0; item < count; ++item) parent_.push_back(item);
    }

    std::uint32_t find(std::uint32_t item) {
        while (parent_[item] != item) {
            parent_[item] = parent_[parent_[item]];
            item = parent_[item];
        }
        return item;
    }

    void unite(std::uint32_t a, std::uint32_t b) {
        a = find(a);
        b = find(b);
        if (a < b) {
            parent_[b] = a;
        } else {
            parent_[a] = b;
        }
    }

private:
    std::vector<std::uint32_t> parent_;
};

}  // namespace ossuary
