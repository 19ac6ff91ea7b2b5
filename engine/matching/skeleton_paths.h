#pragma once

#include <cstdint>
#include <limits>
#include <vector>

namespace ossuary::matching {

struct SkeletonDescriptor;

/// The branch ends at each node of a descriptor; a loop through one node has both ends there.
struct SkeletonAdjacency {
    struct End {
        std::uint32_t branch = 0;
        std::uint32_t node = 0;  ///< at the other end
    };
    std::vector<std::vector<End>> ends;
};

[[nodiscard]] SkeletonAdjacency skeleton_adjacency(const SkeletonDescriptor& descriptor);

/// Shortest ways along branches from one node. Of equally short ones the way over the branch with
/// the lower index is taken.
struct SkeletonPaths {
    std::vector<double> distance;              ///< over the scale; infinite where not reached
    std::vector<std::uint32_t> parent_branch;  ///< 0xFFFFFFFF at the source and where not reached
    std::vector<std::uint32_t> order;          ///< nodes reached, nearest first

    [[nodiscard]] bool reached(std::uint32_t node) const {
        return distance[node] < std::numeric_limits<double>::infinity();
    }
};

[[nodiscard]] SkeletonPaths shortest_paths(const SkeletonDescriptor& descriptor,
                                           const SkeletonAdjacency& adjacency,
                                           std::uint32_t source);

}  // namespace ossuary::matching
