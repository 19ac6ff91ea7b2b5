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

/// The mean geodesic distance of each node to the whole surface, estimated from `sources` nodes
/// that are spread by farthest-point sampling and weighted by the area that is nearest to each.
/// Across pieces of surface that do not touch, the straight distance stands in.
std::vector<float> average_geodesic_distances(const ShellGraph& graph, int sources);

}  // namespace ossuary::descriptor
