#include "engine/matching/skeleton_paths.h"

#include <queue>
#include <tuple>

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
    using Entry = std::tuple<double, std::uint32_t, std::uint32_t>;  // distance, branch, node
    SkeletonPaths paths;
    paths.distance.assign(descriptor.nodes.size(), std::numeric_limits<double>::infinity());
    paths.parent_branch.assign(descriptor.nodes.size(), kNoIndex);
    std::vector<bool> settled(descriptor.nodes.size(), false);
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    queue.emplace(0.0, kNoIndex, source);
    while (!queue.empty()) {
        const auto [distance, branch, node] = queue.top();
        queue.pop();
        if (settled[node]) continue;
        settled[node] = true;
        paths.distance[node] = distance;
        paths.parent_branch[node] = branch;
        paths.order.push_back(node);
        for (const SkeletonAdjacency::End& end : adjacency.ends[node]) {
            if (settled[end.node]) continue;
            const double length = descriptor.branches[end.branch].length;
            queue.emplace(distance + length, end.branch, end.node);
        }
    }
    return paths;
}

}  // namespace ossuary::matching
