#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/descriptor/solid_surface.h"

namespace ossuary::descriptor {

/// A solid's boundary, coarsened to one node for each cubic cell of the grid that holds some of it;
/// nodes of neighbouring cells (26) are joined by an edge as long as their distance.
struct ShellGraph {
    std::vector<Vec3f> points;              ///< centres of gravity, grid units
    std::vector<Vec3f> normals;             ///< unit length, outwards
    std::vector<float> areas;               ///< voxels squared
    std::vector<std::uint32_t> first_edge;  ///< of each node, and one past the last
    std::vector<std::uint32_t> edge_target;
    std::vector<float> edge_length;
    double total_area = 0.0;

    [[nodiscard]] std::size_t size() const { return points.size(); }
    [[nodiscard]] bool empty() const { return points.empty(); }
};

/// @param cell_size  edge of a cell in voxels, at least 1
ShellGraph shell_graph(const SolidSurface& surface, int cell_size);

/// Shortest distances along the graph from `source`; infinite where it cannot reach.
void shortest_distances(const ShellGraph& graph, std::uint32_t source,
                        std::vector<float>& distances);

/// Geodesic distances from some nodes that are spread by farthest-point sampling to all nodes.
/// Across pieces of surface that do not touch, the straight distance stands in.
struct SpreadDistances {
    std::vector<std::uint32_t> sources;    ///< each the farthest from those before it
    std::vector<std::vector<float>> from;  ///< of each source, to each node
    /// The share of the area that is nearest to each of the first `count` sources.
    [[nodiscard]] std::vector<double> shares(const ShellGraph& graph, std::size_t count) const;
};

/// @param sources  fewer where the graph has fewer nodes
SpreadDistances spread_distances(const ShellGraph& graph, int sources);

/// The mean geodesic distance of each node to the whole surface, estimated from the first `sources`
/// of them, weighted by the area that is nearest to each.
std::vector<float> average_geodesic_distances(const ShellGraph& graph,
                                              const SpreadDistances& spread, int sources);

}  // namespace ossuary::descriptor
