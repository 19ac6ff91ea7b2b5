#include "engine/matching/node_clusters.h"

#include <algorithm>
#include <functional>

namespace ossuary::matching {

std::vector<std::uint32_t> NodeClusters::sizes() const {
    std::vector<std::uint32_t> count(parent_.size(), 0);
    for (std::size_t i = 0; i < parent_.size(); ++i) {
        if (matched_[i] != 0) ++count[root(i)];
    }
    std::erase(count, 0U);
    std::sort(count.begin(), count.end(), std::greater<>());
    return count;
}

}  // namespace ossuary::matching
