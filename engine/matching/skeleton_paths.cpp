#include "engine/matching/skeleton_paths.h"

#include <limits>
#include <utility>

#include "engine/core/shortest_ways.h"
#include "engine/matching/skeleton_descriptor.h"

namespace ossuary::matching {

SkeletonAdjacency skeleton_adjacency(const SkeletonDescriptor& descriptor) {
    SkeletonAdjacency adjacency;
    adjacency.ends.resize(descriptor.nodes.size());
    for (std::uint32_t i = 0; i < descriptor.branches.size(); ++i) {
        const SkeletonDescriptor::Branch& branch = descriptor.branches[i];
        adjacency.ends[branch.a].push_back({i, branch.b});
        adjacency.ends[branch.b].push_back({i, branch.a});
    }
    return adjacency;
}

SkeletonPaths shortest_paths(const SkeletonDescriptor& descriptor,
                             const SkeletonAdjacency& adjacency, std::uint32_t source) {
    // Of equally long ways the one through the branch that comes first.
    using Key = std::pair<double, std::uint32_t>;  // distance, branch
    constexpr double kUnreached = std::numeric_limits<double>::infinity();
    std::vector<Key> least(descriptor.nodes.size(), {kUnreached, kNoIndex});
    least[source].first = 0.0;
    std::vector<bool> settled(descriptor.nodes.size(), false);
    const auto links = [&](std::uint32_t node, const auto& reach) {
        for (const SkeletonAdjacency::End& end : adjacency.ends[node]) {
            if (settled[end.node]) continue;  // a branch without length leads back
            const double length = descriptor.branches[end.branch].length;
            reach(end.node, Key{least[node].first + length, end.branch});
        }
    };
    SkeletonPaths paths;
    ShortestWays<Key>().search(least, std::span(&source, 1), links, [&](std::uint32_t node) {
        settled[node] = true;
        paths.order.push_back(node);
    });
    for (const auto& [distance, branch] : least) {
        paths.distance.push_back(distance);
        paths.parent_branch.push_back(branch);
    }
    return paths;
}

}  // namespace ossuary::matching
