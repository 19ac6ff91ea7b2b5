#include "engine/matching/sampled_tree.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "engine/matching/resample.h"
#include "engine/matching/skeleton_paths.h"

namespace ossuary::matching {
namespace {

constexpr double kSmallestRadius = 1e-3;
constexpr int kMaxPieces = 64;  // of one branch

/// A stretch of branch between two nodes of the graph, or to the point where a cycle was cut.
struct Edge {
    std::uint32_t branch;
    double from, to;  // shares of the branch's length
    std::uint32_t start, end;
};

/// Appends the edges of the tree that shortest ways from `top` make of its component.
void append_edges(const SkeletonDescriptor& descriptor, const SkeletonPaths& paths,
                  std::vector<Edge>& edges) {
    std::vector<bool> used(descriptor.branches.size(), false);
    for (const std::uint32_t node : paths.order) {
        const std::uint32_t index = paths.parent_branch[node];
        if (index == kNoIndex) continue;
        used[index] = true;
        const SkeletonDescriptor::Branch& branch = descriptor.branches[index];
        const bool forward = branch.b == node;
        edges.push_back(
            {index, forward ? 0.0 : 1.0, forward ? 1.0 : 0.0, forward ? branch.a : branch.b, node});
    }
    for (std::uint32_t index = 0; index < descriptor.branches.size(); ++index) {
        const SkeletonDescriptor::Branch& branch = descriptor.branches[index];
        if (used[index] || !paths.reached(branch.a) || branch.length <= 0.0F) continue;
        const double ahead = paths.distance[branch.b] - paths.distance[branch.a];
        const double cut = std::clamp(0.5 * (1.0 + ahead / branch.length), 0.0, 1.0);
        if (cut > 0.0) edges.push_back({index, 0.0, cut, branch.a, kNoIndex});
        if (cut < 1.0) edges.push_back({index, 1.0, cut, branch.b, kNoIndex});
    }
}

/// Hangs a tree of edges up at nodes of the graph.
class Hanger {
public:
    Hanger(const SkeletonDescriptor& descriptor, const SampleTreeOptions& options,
           std::vector<Edge> edges, const std::stop_token& stop)
        : descriptor_(descriptor), options_(options), edges_(std::move(edges)), stop_(stop) {
        ends_.resize(descriptor.nodes.size());
        for (std::uint32_t i = 0; i < edges_.size(); ++i) {
            ends_[edges_[i].start].push_back({i, true});
            if (edges_[i].end != kNoIndex) ends_[edges_[i].end].push_back({i, false});
        }
    }

    void hang(std::uint32_t graph_node) {
        SampledTree::Top top;
        top.graph_node = graph_node;
        for (const Walk& walk : ends_[graph_node]) {
            if (stop_.stop_requested()) return;
            const Hung hung = below(walk);
            top.children.push_back(hung.first_piece);
            top.length += hung.length;
        }
        tree_.tops.push_back(std::move(top));
    }

    [[nodiscard]] SampledTree finish() {
        tree_.shape = tree_shape(children_);
        return std::move(tree_);
    }

private:
    struct Walk {
        std::uint32_t edge;
        bool forward;
        bool operator<(const Walk& other) const {
            return edge != other.edge ? edge < other.edge : forward < other.forward;
        }
    };
    /// An edge walked one way with all that lies beyond it.
    struct Hung {
        std::uint32_t first_piece;
        float length;
    };

    /// Depth first with a stack of its own: a skeleton may be a chain of thousands of nodes.
    Hung below(const Walk& walk) {
        std::vector<Walk> open = {walk};
        while (!open.empty()) {
            if (stop_.stop_requested()) return {};
            const Walk current = open.back();
            if (known_.contains(current)) {
                open.pop_back();
                continue;
            }
            std::vector<Walk> missing;
            for (const Walk& next : beyond(current)) {
                if (!known_.contains(next)) missing.push_back(next);
            }
            if (missing.empty()) {
                known_.emplace(current, add_pieces(current));
                open.pop_back();
            }
            open.insert(open.end(), missing.begin(), missing.end());
        }
        return known_.at(walk);
    }

    [[nodiscard]] std::vector<Walk> beyond(const Walk& walk) const {
        const Edge& edge = edges_[walk.edge];
        const std::uint32_t node = walk.forward ? edge.end : edge.start;
        std::vector<Walk> next;
        if (node == kNoIndex) return next;
        for (const Walk& each : ends_[node]) {
            if (each.edge != walk.edge) next.push_back(each);
        }
        return next;
    }

    /// Appends the pieces of an edge, the last first.
    Hung add_pieces(const Walk& walk) {
        const Edge& edge = edges_[walk.edge];
        const SkeletonDescriptor::Branch& branch = descriptor_.branches[edge.branch];
        const double from = walk.forward ? edge.from : edge.to;
        const double to = walk.forward ? edge.to : edge.from;
        const double length = branch.length * std::abs(to - from) * options_.scale;
        const int count = static_cast<int>(
            std::clamp(std::round(length / options_.step), 1.0, double{kMaxPieces}));
        const ResampledCurve curve = resample_evenly(branch.points, branch.radii, from, to, count);
        std::vector<std::uint32_t> children;
        Hung hung{0, static_cast<float>(length)};
        for (const Walk& next : beyond(walk)) {
            children.push_back(known_.at(next).first_piece);
            hung.length += known_.at(next).length;
        }
        for (int i = count; i-- > 0;) {
            SampledTree::Node node;
            node.branch = edge.branch;
            if (i + 1 == count) node.graph_node = walk.forward ? edge.end : edge.start;
            const auto at = static_cast<std::size_t>(i);
            const double radius =
                0.5 * options_.scale * (static_cast<double>(curve.radii[at]) + curve.radii[at + 1]);
            node.log_radius = static_cast<float>(std::log(std::max(radius, kSmallestRadius)));
            node.length = static_cast<float>(length / count);
            if (i > 0) node.turn = turn(curve, at);
            tree_.nodes.push_back(node);
            children_.push_back(std::move(children));
            children = {static_cast<std::uint32_t>(tree_.nodes.size() - 1)};
        }
        hung.first_piece = children.front();
        return hung;
    }

    static float turn(const ResampledCurve& curve, std::size_t at) {
        const Vec3f before = curve.points[at] - curve.points[at - 1];
        const Vec3f after = curve.points[at + 1] - curve.points[at];
        const float angle = std::atan2(before.cross(after).norm(), before.dot(after));
        return angle / std::numbers::pi_v<float>;
    }

    const SkeletonDescriptor& descriptor_;
    const SampleTreeOptions& options_;
    std::vector<Edge> edges_;
    const std::stop_token& stop_;
    std::vector<std::vector<Walk>> ends_;
    std::map<Walk, Hung> known_;
    SampledTree tree_;
    std::vector<std::vector<std::uint32_t>> children_;
};

}  // namespace

SampledTree sample_tree(const SkeletonDescriptor& descriptor, const SampleTreeOptions& options,
                        const std::stop_token& stop) {
    if (descriptor.rooted.trees.empty()) return {};
    // The middle of each component, the heaviest first.
    std::vector<std::uint32_t> middles;
    const RootedTree& rooted = descriptor.rooted.trees.front();
    for (auto node = rooted.nodes.rbegin(); node != rooted.nodes.rend(); ++node) {
        if (node->piece == kNoIndex) middles.push_back(node->graph_node);
    }
    if (options.every_top) middles.resize(1);
    const SkeletonAdjacency adjacency = skeleton_adjacency(descriptor);
    std::vector<Edge> edges;
    std::vector<std::uint32_t> tops;
    for (const std::uint32_t middle : middles) {
        const SkeletonPaths paths = shortest_paths(descriptor, adjacency, middle);
        append_edges(descriptor, paths, edges);
        if (options.every_top) {
            tops = paths.order;
        } else {
            tops.push_back(middle);
        }
    }
    Hanger hanger(descriptor, options, std::move(edges), stop);
    for (const std::uint32_t top : tops) hanger.hang(top);
    if (stop.stop_requested()) return {};
    return hanger.finish();
}

}  // namespace ossuary::matching
