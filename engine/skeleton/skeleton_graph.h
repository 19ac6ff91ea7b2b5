#pragma once

#include <cstdint>
#include <vector>

#include "engine/core/geometry.h"

namespace ossuary::skeleton {

/// A curve skeleton as a graph. Coordinates and radii are in one unit throughout: voxels of the
/// grid while the skeleton is being made, the model's own units once `to_world` has been applied.
struct SkeletonGraph {
    struct Node {
        Vec3 position = Vec3::Zero();
        double radius = 0.0;        ///< of the largest inscribed ball, from the distance transform
        double significance = 0.0;  ///< eq. 3.3
        int degree = 0;             ///< branch ends here; a loop at one node counts twice
    };
    struct Branch {
        std::uint32_t a = 0;        ///< index into `nodes`
        std::uint32_t b = 0;        ///< equals `a` for a loop through one node
        std::vector<Vec3> points;   ///< from node a to node b, both included; at least two
        std::vector<double> radii;  ///< as long as `points`
        [[nodiscard]] double length() const;  ///< of the polyline
    };

    std::vector<Node> nodes;
    std::vector<Branch> branches;

    [[nodiscard]] bool empty() const { return nodes.empty(); }
};

/// The same skeleton in the model's own coordinates and units.
[[nodiscard]] SkeletonGraph to_world(const SkeletonGraph& grid,
                                     const WorldFromGrid& world_from_grid);

/// Sets every node's degree from the branches.
void update_degrees(SkeletonGraph& graph);

/// Connected components and independent cycles of the graph.
struct GraphTopology {
    int components = 0;
    int cycles = 0;
    bool operator==(const GraphTopology&) const = default;
};
[[nodiscard]] GraphTopology topology(const SkeletonGraph& graph);

}  // namespace ossuary::skeleton
