#include "engine/skeleton/extract_graph.h"

#include <algorithm>
#include <unordered_map>

#include "engine/skeleton/junction_clusters.h"
#include "engine/skeleton/thinning_grid.h"

namespace ossuary::skeleton {
namespace {

/// Clusters above this many voxels are closed surfaces, not junctions: they become one node as they
/// are.
constexpr std::size_t kLargestSplitCluster = 200;

class GraphExtraction {
public:
    GraphExtraction(const voxel::BitVolume& skeleton, const voxel::DistanceField& distance)
        : grid_(skeleton), distance_(distance), steps_(grid_.shape().neighbor_steps()) {}

    SkeletonGraph run(const std::stop_token& stop) {
        grid_.for_each([&](VoxelIndex v) {
            if (stop.stop_requested()) return;
            const int valence = std::popcount(grid_.neighborhood(v) & k26Neighbors);
            if (valence <= 1) {
                add_node({v});
            } else if (valence > 2 && !node_of_.contains(v)) {
                add_cluster(v);
            }
        });
        // Chains end at nodes: without all of them there is no following them.
        if (stop.stop_requested()) return {};
        connect_touching_nodes();
        // Nodes and their voxels by number, so that the order of branches follows that of voxels.
        for (std::uint32_t node = 0; node < voxels_of_.size(); ++node) {
            for (const VoxelIndex v : voxels_of_[node]) trace_from(v, node);
        }
        grid_.for_each([&](VoxelIndex v) {
            if (!node_of_.contains(v) && !traced_.contains(v)) trace_loop(v);
        });
        update_degrees(graph_);
        return std::move(graph_);
    }

private:
    [[nodiscard]] Vec3 centre_of(VoxelIndex v) const {
        return grid_.shape().position(v).cast<double>() + Vec3::Constant(0.5);
    }
    [[nodiscard]] double radius_of(VoxelIndex v) const {
        return distance_.distance(grid_.shape().position(v));
    }
    template <typename Visit>
    void for_each_neighbor(VoxelIndex v, Visit&& visit) const {
        for_each_bit(grid_.neighborhood(v) & k26Neighbors,
                     [&](int bit) { visit(moved(v, steps_[static_cast<std::size_t>(bit)])); });
    }

    void add_node(const std::vector<VoxelIndex>& voxels) {
        SkeletonGraph::Node node;
        for (const VoxelIndex v : voxels) {
            node.position += centre_of(v);
            node.radius = std::max(node.radius, radius_of(v));
            node_of_[v] = static_cast<std::uint32_t>(graph_.nodes.size());
        }
        node.position /= static_cast<double>(voxels.size());
        graph_.nodes.push_back(node);
        voxels_of_.push_back(voxels);
    }

    void add_cluster(VoxelIndex seed) {
        std::vector<VoxelIndex> cluster = {seed};
        std::unordered_map<VoxelIndex, bool> seen = {{seed, true}};
        for (std::size_t i = 0; i < cluster.size(); ++i) {
            for_each_neighbor(cluster[i], [&](VoxelIndex n) {
                if (seen.contains(n) || std::popcount(grid_.neighborhood(n) & k26Neighbors) <= 2) {
                    return;
                }
                seen[n] = true;
                cluster.push_back(n);
            });
        }
        std::sort(cluster.begin(), cluster.end());
        if (cluster.size() > kLargestSplitCluster) {
            add_node(cluster);
            return;
        }
        const auto first = static_cast<std::uint32_t>(graph_.nodes.size());
        for (const auto& piece : contractible_pieces(cluster, grid_.shape())) add_node(piece);
        for (std::uint32_t a = first; a < graph_.nodes.size(); ++a) {
            for (std::uint32_t b = a + 1; b < graph_.nodes.size(); ++b) {
                const int count = contacts(voxels_of_[a], voxels_of_[b], grid_.shape());
                for (int i = 0; i < count; ++i) add_branch(a, b, {});
            }
        }
    }

    void add_branch(std::uint32_t a, std::uint32_t b, const std::vector<VoxelIndex>& between) {
        SkeletonGraph::Branch branch;
        branch.a = a;
        branch.b = b;
        branch.points.push_back(graph_.nodes[a].position);
        branch.radii.push_back(graph_.nodes[a].radius);
        for (const VoxelIndex v : between) {
            branch.points.push_back(centre_of(v));
            branch.radii.push_back(radius_of(v));
        }
        branch.points.push_back(graph_.nodes[b].position);
        branch.radii.push_back(graph_.nodes[b].radius);
        graph_.branches.push_back(std::move(branch));
    }

    /// Ends that touch a junction or another end without a voxel between.
    void connect_touching_nodes() {
        for (std::uint32_t node = 0; node < voxels_of_.size(); ++node) {
            const std::vector<VoxelIndex>& voxels = voxels_of_[node];
            if (voxels.size() != 1) continue;
            const Neighborhood around = grid_.neighborhood(voxels.front()) & k26Neighbors;
            if (std::popcount(around) != 1) continue;
            for_each_neighbor(voxels.front(), [&](VoxelIndex n) {
                const auto other = node_of_.find(n);
                if (other == node_of_.end()) return;
                const bool is_end = std::popcount(grid_.neighborhood(n) & k26Neighbors) == 1;
                if (!is_end || node < other->second) add_branch(node, other->second, {});
            });
        }
    }

    /// Follows each chain that leaves a node's voxel; `traced_` keeps it from being followed back.
    void trace_from(VoxelIndex start, std::uint32_t node) {
        for_each_neighbor(start, [&](VoxelIndex first) {
            if (node_of_.contains(first) || traced_.contains(first)) return;
            std::vector<VoxelIndex> chain = {first};
            traced_[first] = true;
            VoxelIndex before = start;
            for (;;) {
                VoxelIndex next = before;
                for_each_neighbor(chain.back(), [&](VoxelIndex n) {
                    if (n != before) next = n;
                });
                const auto end = node_of_.find(next);
                if (end != node_of_.end()) {
                    add_branch(node, end->second, chain);
                    return;
                }
                before = chain.back();
                chain.push_back(next);
                traced_[next] = true;
            }
        });
    }

    void trace_loop(VoxelIndex seed) {
        std::vector<VoxelIndex> loop = {seed};
        VoxelIndex before = seed;
        for_each_neighbor(seed, [&](VoxelIndex n) { before = n; });
        for (;;) {
            VoxelIndex next = before;
            for_each_neighbor(loop.back(), [&](VoxelIndex n) {
                if (n != before) next = n;
            });
            if (next == seed) break;
            before = loop.back();
            loop.push_back(next);
        }
        const auto deepest =
            std::max_element(loop.begin(), loop.end(), [&](VoxelIndex a, VoxelIndex b) {
                return radius_of(a) < radius_of(b) || (radius_of(a) == radius_of(b) && a > b);
            });
        std::rotate(loop.begin(), deepest, loop.end());
        for (const VoxelIndex v : loop) traced_[v] = true;
        add_node({loop.front()});
        const auto node = static_cast<std::uint32_t>(graph_.nodes.size() - 1);
        add_branch(node, node, {loop.begin() + 1, loop.end()});
    }

    ThinningGrid grid_;
    const voxel::DistanceField& distance_;
    std::array<std::int32_t, 27> steps_;
    SkeletonGraph graph_;
    std::vector<std::vector<VoxelIndex>> voxels_of_;  ///< of each node
    std::unordered_map<VoxelIndex, std::uint32_t> node_of_;
    std::unordered_map<VoxelIndex, bool> traced_;  ///< voxels inside branches
};

}  // namespace

SkeletonGraph extract_graph(const voxel::BitVolume& skeleton, const voxel::DistanceField& distance,
                            const std::stop_token& stop) {
    return GraphExtraction(skeleton, distance).run(stop);
}

}  // namespace ossuary::skeleton
