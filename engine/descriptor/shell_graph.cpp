#include "engine/descriptor/shell_graph.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

namespace ossuary::descriptor {
namespace {

constexpr float kUnreached = std::numeric_limits<float>::infinity();
constexpr std::uint32_t kNoNode = 0xFFFFFFFFU;

/// Which node a cell holds, with an empty layer around the cells so that neighbours need no check.
struct CellGrid {
    Vec3i size = Vec3i::Zero();
    std::vector<std::uint32_t> node;

    [[nodiscard]] std::size_t index(const Vec3i& cell) const {
        return (static_cast<std::size_t>(cell.z() + 1) * static_cast<std::size_t>(size.y()) +
                static_cast<std::size_t>(cell.y() + 1)) *
                   static_cast<std::size_t>(size.x()) +
               static_cast<std::size_t>(cell.x() + 1);
    }
};

/// Fills the nodes of the graph; returns the cell of each.
std::vector<Vec3i> add_nodes(const SolidSurface& surface, int cell_size, CellGrid& grid,
                             ShellGraph& graph) {
    Vec3i largest = Vec3i::Zero();
    for (const Vec3i& v : surface.voxels) largest = largest.cwiseMax(v);
    grid.size = (largest / cell_size).array() + 3;
    grid.node.assign(static_cast<std::size_t>(grid.size.prod()), kNoNode);
    std::vector<Vec3i> cells;
    for (std::size_t i = 0; i < surface.voxels.size(); ++i) {
        const Vec3i cell = surface.voxels[i] / cell_size;
        std::uint32_t& node = grid.node[grid.index(cell)];
        if (node == kNoNode) {
            node = static_cast<std::uint32_t>(cells.size());
            cells.push_back(cell);
            graph.points.push_back(Vec3f::Zero());
            graph.normals.push_back(Vec3f::Zero());
            graph.areas.push_back(0.0F);
        }
        graph.points[node] += surface.areas[i] * surface.points[i];
        graph.normals[node] += surface.areas[i] * surface.normals[i];
        graph.areas[node] += surface.areas[i];
    }
    for (std::size_t node = 0; node < cells.size(); ++node) {
        graph.points[node] /= graph.areas[node];
        const float length = graph.normals[node].norm();
        graph.normals[node] =
            length > 1e-6F ? (graph.normals[node] / length).eval() : Vec3f::UnitZ().eval();
        graph.total_area += static_cast<double>(graph.areas[node]);
    }
    return cells;
}

void add_edges(const std::vector<Vec3i>& cells, const CellGrid& grid, ShellGraph& graph) {
    std::vector<std::ptrdiff_t> offsets;
    for (int z = -1; z <= 1; ++z) {
        for (int y = -1; y <= 1; ++y) {
            for (int x = -1; x <= 1; ++x) {
                if (x == 0 && y == 0 && z == 0) continue;
                offsets.push_back(
                    (static_cast<std::ptrdiff_t>(z) * grid.size.y() + y) * grid.size.x() + x);
            }
        }
    }
    graph.first_edge.reserve(cells.size() + 1);
    graph.first_edge.push_back(0);
    for (std::size_t node = 0; node < cells.size(); ++node) {
        const auto at = static_cast<std::ptrdiff_t>(grid.index(cells[node]));
        for (const std::ptrdiff_t offset : offsets) {
            const std::uint32_t other = grid.node[static_cast<std::size_t>(at + offset)];
            if (other == kNoNode) continue;
            graph.edge_target.push_back(other);
            graph.edge_length.push_back((graph.points[other] - graph.points[node]).norm());
        }
        graph.first_edge.push_back(static_cast<std::uint32_t>(graph.edge_target.size()));
    }
}

}  // namespace

ShellGraph shell_graph(const SolidSurface& surface, int cell_size) {
    assert(cell_size >= 1);
    ShellGraph graph;
    CellGrid grid;
    const std::vector<Vec3i> cells = add_nodes(surface, cell_size, grid, graph);
    add_edges(cells, grid, graph);
    return graph;
}

void shortest_distances(const ShellGraph& graph, std::uint32_t source,
                        std::vector<float>& distances) {
    struct Entry {
        float distance;
        std::uint32_t node;
    };
    const auto later = [](const Entry& a, const Entry& b) {
        return a.distance != b.distance ? a.distance > b.distance : a.node > b.node;
    };
    distances.assign(graph.size(), kUnreached);
    distances[source] = 0.0F;
    std::vector<Entry> heap = {{0.0F, source}};
    while (!heap.empty()) {
        std::pop_heap(heap.begin(), heap.end(), later);
        const Entry entry = heap.back();
        heap.pop_back();
        if (entry.distance > distances[entry.node]) continue;
        for (std::uint32_t e = graph.first_edge[entry.node]; e < graph.first_edge[entry.node + 1];
             ++e) {
            const std::uint32_t target = graph.edge_target[e];
            const float distance = entry.distance + graph.edge_length[e];
            if (distance >= distances[target]) continue;
            distances[target] = distance;
            heap.push_back({distance, target});
            std::push_heap(heap.begin(), heap.end(), later);
        }
    }
}

SpreadDistances spread_distances(const ShellGraph& graph, int sources) {
    SpreadDistances spread;
    const std::size_t count = graph.size();
    if (count == 0) return spread;
    const std::size_t wanted = std::min(static_cast<std::size_t>(sources), count);
    std::vector<float> nearest(count, kUnreached);
    // The first source is the node farthest from node 0, so that it depends on the shape alone.
    std::uint32_t next = 0;
    for (std::size_t s = 0; s <= wanted; ++s) {
        std::vector<float> distances;
        shortest_distances(graph, next, distances);
        for (std::size_t i = 0; i < count; ++i) {
            if (distances[i] == kUnreached) {
                distances[i] = (graph.points[i] - graph.points[next]).norm();
            }
        }
        if (s == 0) {
            next = static_cast<std::uint32_t>(std::max_element(distances.begin(), distances.end()) -
                                              distances.begin());
            continue;
        }
        for (std::size_t i = 0; i < count; ++i) nearest[i] = std::min(nearest[i], distances[i]);
        spread.sources.push_back(next);
        spread.from.push_back(std::move(distances));
        next = static_cast<std::uint32_t>(std::max_element(nearest.begin(), nearest.end()) -
                                          nearest.begin());
    }
    return spread;
}

std::vector<double> SpreadDistances::shares(const ShellGraph& graph, std::size_t count) const {
    std::vector<double> shares(std::min(count, from.size()), 0.0);
    if (shares.empty()) return shares;
    for (std::size_t i = 0; i < graph.size(); ++i) {
        std::size_t nearest = 0;
        for (std::size_t s = 1; s < shares.size(); ++s) {
            if (from[s][i] < from[nearest][i]) nearest = s;
        }
        shares[nearest] += static_cast<double>(graph.areas[i]) / graph.total_area;
    }
    return shares;
}

std::vector<float> average_geodesic_distances(const ShellGraph& graph,
                                              const SpreadDistances& spread, int sources) {
    std::vector<float> average(graph.size(), 0.0F);
    const std::vector<double> shares = spread.shares(graph, static_cast<std::size_t>(sources));
    for (std::size_t s = 0; s < shares.size(); ++s) {
        const auto share = static_cast<float>(shares[s]);
        for (std::size_t i = 0; i < graph.size(); ++i) average[i] += share * spread.from[s][i];
    }
    return average;
}

}  // namespace ossuary::descriptor
