#include "engine/skeleton/skeleton_graph.h"

#include "engine/mesh/disjoint_sets.h"

namespace ossuary::skeleton {

double SkeletonGraph::Branch::length() const {
    double total = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) total += (points[i] - points[i - 1]).norm();
    return total;
}

SkeletonGraph to_world(const SkeletonGraph& grid, const WorldFromGrid& world_from_grid) {
    SkeletonGraph world = grid;
    for (SkeletonGraph::Node& node : world.nodes) {
        node.position = world_from_grid.point(node.position);
        node.radius = world_from_grid.length(node.radius);
        node.significance = world_from_grid.length(node.significance);
    }
    for (SkeletonGraph::Branch& branch : world.branches) {
        for (Vec3& point : branch.points) point = world_from_grid.point(point);
        for (double& radius : branch.radii) radius = world_from_grid.length(radius);
    }
    return world;
}

void update_degrees(SkeletonGraph& graph) {
    for (SkeletonGraph::Node& node : graph.nodes) node.degree = 0;
    for (const SkeletonGraph::Branch& branch : graph.branches) {
        ++graph.nodes[branch.a].degree;
        ++graph.nodes[branch.b].degree;
    }
}

GraphTopology topology(const SkeletonGraph& graph) {
    mesh::DisjointSets sets(graph.nodes.size());
    int components = static_cast<int>(graph.nodes.size());
    for (const SkeletonGraph::Branch& branch : graph.branches) {
        if (sets.find(branch.a) == sets.find(branch.b)) continue;
        sets.unite(branch.a, branch.b);
        --components;
    }
    const int cycles =
        static_cast<int>(graph.branches.size()) - static_cast<int>(graph.nodes.size()) + components;
    return {components, cycles};
}

}  // namespace ossuary::skeleton
