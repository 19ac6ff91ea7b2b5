#include "engine/matching/rooted_skeleton.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <tuple>

#include "engine/matching/resample.h"
#include "engine/matching/skeleton_descriptor.h"
#include "engine/matching/skeleton_paths.h"

namespace ossuary::matching {
namespace {

/// How heavy a point of the skeleton is.
double density(double radius, double power) { return std::pow(std::max(radius, 1e-6), power); }

/// Sum over the skeleton's points of density times geodesic distance from the source of `paths`.
double eccentricity(const SkeletonDescriptor& descriptor, const SkeletonPaths& paths,
                    double power) {
    double sum = 0.0;
    for (const SkeletonDescriptor::Branch& branch : descriptor.branches) {
        if (!paths.reached(branch.a)) continue;
        const std::size_t count = branch.radii.size();
        const double step = branch.length / static_cast<double>(count - 1);
        for (std::size_t i = 0; i < count; ++i) {
            const double along = step * static_cast<double>(i);
            const double distance = std::min(paths.distance[branch.a] + along,
                                             paths.distance[branch.b] + branch.length - along);
            const double share = i == 0 || i + 1 == count ? 0.5 : 1.0;
            sum += share * step * density(branch.radii[i], power) * distance;
        }
    }
    return sum;
}

struct Component {
    std::vector<std::uint32_t> nodes;
    double mass = 0.0;
    std::vector<std::uint32_t> roots;  ///< most central first
};

std::vector<Component> find_components(const SkeletonDescriptor& descriptor,
                                       const SkeletonAdjacency& adjacency, double power) {
    std::vector<Component> components;
    std::vector<std::uint32_t> component_of(descriptor.nodes.size(), kNoIndex);
    for (std::uint32_t seed = 0; seed < descriptor.nodes.size(); ++seed) {
        if (component_of[seed] != kNoIndex) continue;
        const auto index = static_cast<std::uint32_t>(components.size());
        Component& component = components.emplace_back();
        component.nodes.push_back(seed);
        component_of[seed] = index;
        for (std::size_t next = 0; next < component.nodes.size(); ++next) {
            for (const SkeletonAdjacency::End& end : adjacency.ends[component.nodes[next]]) {
                if (component_of[end.node] != kNoIndex) continue;
                component_of[end.node] = index;
                component.nodes.push_back(end.node);
            }
        }
    }
    for (const SkeletonDescriptor::Branch& branch : descriptor.branches) {
        double sum = 0.0;
        for (const float radius : branch.radii) sum += density(radius, power);
        components[component_of[branch.a]].mass +=
            branch.length * sum / static_cast<double>(branch.radii.size());
    }
    // An isolated point counts as a ball.
    for (Component& component : components) {
        for (const std::uint32_t node : component.nodes) {
            const double radius = descriptor.nodes[node].radius;
            component.mass += 1e-3 * radius * density(radius, power);
        }
    }
    return components;
}

/// Sets `roots`: at most `count` of the component's nodes that may be its root.
void choose_roots(const SkeletonDescriptor& descriptor, const SkeletonAdjacency& adjacency,
                  Component& component, std::size_t count, double power) {
    std::vector<std::uint32_t> candidates;
    for (const bool junctions : {true, false}) {
        for (const std::uint32_t node : component.nodes) {
            const std::size_t degree = adjacency.ends[node].size();
            if (junctions ? degree >= 3 : degree == 1) candidates.push_back(node);
        }
        if (!candidates.empty()) break;
    }
    if (candidates.empty()) candidates = component.nodes;
    std::vector<std::pair<double, std::uint32_t>> ranked;
    for (const std::uint32_t node : candidates) {
        const SkeletonPaths paths = shortest_paths(descriptor, adjacency, node);
        ranked.emplace_back(eccentricity(descriptor, paths, power), node);
    }
    std::sort(ranked.begin(), ranked.end());
    for (std::size_t i = 0; i < std::min(count, ranked.size()); ++i) {
        component.roots.push_back(ranked[i].second);
    }
}

/// Gathers the pieces of branch that the trees are made of.
class PieceStore {
public:
    PieceStore(const SkeletonDescriptor& descriptor, RootedSkeletons& rooted)
        : descriptor_(descriptor), rooted_(rooted) {}

    /// The piece of a branch between two shares of its length, walked from `from` to `to`.
    std::uint32_t piece(std::uint32_t branch, double from, double to) {
        const auto [place, is_new] = known_.try_emplace(
            {branch, from, to}, static_cast<std::uint32_t>(rooted_.pieces.size()));
        if (is_new) add(branch, from, to);
        return place->second;
    }

private:
    void add(std::uint32_t index, double from, double to) {
        const SkeletonDescriptor::Branch& branch = descriptor_.branches[index];
        const ResampledCurve curve = resample_part(branch.points, branch.radii, from, to,
                                                   static_cast<int>(chain_code::kMaxAlignedSteps));
        const std::vector<chain_code::DirectionStep> code =
            chain_code::direction_code(curve.points, curve.radii);
        RootedSkeletons::Piece piece;
        piece.branch = index;
        piece.first_step = static_cast<std::uint32_t>(rooted_.steps.size());
        piece.step_count = static_cast<std::uint32_t>(code.size());
        piece.length = static_cast<float>(branch.length * std::abs(to - from));
        rooted_.steps.insert(rooted_.steps.end(), code.begin(), code.end());
        rooted_.pieces.push_back(piece);
    }

    const SkeletonDescriptor& descriptor_;
    RootedSkeletons& rooted_;
    std::map<std::tuple<std::uint32_t, double, double>, std::uint32_t> known_;
};

/// A tree node with the stretch of branch that leads to it: pieces are cut once it is known which
/// nodes stay.
struct GatheredNode : RootedTree::Node {
    std::uint32_t branch = kNoIndex;  ///< none at a component's root
    double from = 0.0, to = 0.0;      ///< as for PieceStore
};
/// Tree nodes while they are gathered, parents before children.
using Gathered = std::vector<GatheredNode>;

/// Appends the tree of one component below gathered node `root`.
void gather_component(const SkeletonDescriptor& descriptor, const SkeletonAdjacency& adjacency,
                      std::uint32_t root, Gathered& gathered) {
    const std::uint32_t graph_root = gathered[root].graph_node;
    const float offset = gathered[root].root_distance;
    const SkeletonPaths paths = shortest_paths(descriptor, adjacency, graph_root);
    std::vector<std::uint32_t> tree_node(descriptor.nodes.size(), kNoIndex);
    tree_node[graph_root] = root;
    std::vector<bool> used(descriptor.branches.size(), false);
    const auto append = [&](std::uint32_t branch, double from, double to, std::uint32_t start,
                            std::uint32_t end) {
        GatheredNode node;
        node.branch = branch;
        node.from = from;
        node.to = to;
        node.graph_node = end;
        node.parent = tree_node[start];
        node.weight = static_cast<float>(descriptor.branches[branch].length * std::abs(to - from));
        node.root_distance = offset + static_cast<float>(paths.distance[start]);
        if (end != kNoIndex) node.radius = descriptor.nodes[end].radius;
        gathered.push_back(node);
    };
    for (const std::uint32_t node : paths.order) {
        if (node == graph_root) continue;
        const std::uint32_t index = paths.parent_branch[node];
        const SkeletonDescriptor::Branch& branch = descriptor.branches[index];
        used[index] = true;
        const bool forward = branch.b == node;
        const std::uint32_t start = forward ? branch.a : branch.b;
        tree_node[node] = static_cast<std::uint32_t>(gathered.size());
        append(index, forward ? 0.0 : 1.0, forward ? 1.0 : 0.0, start, node);
    }
    for (std::uint32_t index = 0; index < descriptor.branches.size(); ++index) {
        const SkeletonDescriptor::Branch& branch = descriptor.branches[index];
        if (used[index] || !paths.reached(branch.a)) continue;
        const double ahead = paths.distance[branch.b] - paths.distance[branch.a];
        const double length = branch.length;
        const double cut =
            length > 0.0 ? std::clamp(0.5 * (length + ahead) / length, 0.0, 1.0) : 0.5;
        if (cut > 0.0) append(index, 0.0, cut, branch.a, kNoIndex);
        if (cut < 1.0) append(index, 1.0, cut, branch.b, kNoIndex);
    }
}

/// Takes the lightest leaves away until at most `limit` nodes are left.
void limit_size(Gathered& gathered, std::size_t limit) {
    std::vector<std::uint32_t> child_count(gathered.size(), 0);
    for (const GatheredNode& node : gathered) {
        if (node.parent != kNoIndex) ++child_count[node.parent];
    }
    std::vector<bool> gone(gathered.size(), false);
    for (std::size_t left = gathered.size(); left > limit; --left) {
        std::size_t lightest = gathered.size();
        for (std::size_t i = 1; i < gathered.size(); ++i) {
            if (gone[i] || child_count[i] > 0) continue;
            if (lightest == gathered.size() || gathered[i].weight < gathered[lightest].weight) {
                lightest = i;
            }
        }
        gone[lightest] = true;
        --child_count[gathered[lightest].parent];
    }
    std::vector<std::uint32_t> renumbered(gathered.size(), kNoIndex);
    Gathered kept;
    for (std::size_t i = 0; i < gathered.size(); ++i) {
        if (gone[i]) continue;
        renumbered[i] = static_cast<std::uint32_t>(kept.size());
        kept.push_back(gathered[i]);
        if (kept.back().parent != kNoIndex) kept.back().parent = renumbered[kept.back().parent];
    }
    gathered = std::move(kept);
}

RootedTree finish(Gathered gathered, PieceStore& pieces) {
    RootedTree tree;
    const auto count = static_cast<std::uint32_t>(gathered.size());
    for (GatheredNode& node : gathered) {
        if (node.branch != kNoIndex) node.piece = pieces.piece(node.branch, node.from, node.to);
    }
    std::reverse(gathered.begin(), gathered.end());
    for (GatheredNode& node : gathered) {
        if (node.parent != kNoIndex) node.parent = count - 1 - node.parent;
        tree.total_weight += node.weight;
    }
    tree.nodes.assign(gathered.begin(), gathered.end());
    return tree;
}

/// Fills in `merged` of the trees and of the whole.
void merge_trees(RootedSkeletons& rooted) {
    // What a subtree is: the piece and node at its top, and the subtrees below.
    using Key = std::tuple<std::uint32_t, std::uint32_t, std::vector<std::uint32_t>>;
    std::map<Key, std::uint32_t> known;
    std::vector<std::vector<std::uint32_t>> all_children;
    for (RootedTree& tree : rooted.trees) {
        std::vector<std::vector<std::uint32_t>> children(tree.nodes.size());
        for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
            const RootedTree::Node& node = tree.nodes[i];
            std::sort(children[i].begin(), children[i].end());
            const auto [place, is_new] =
                known.try_emplace({node.piece, node.graph_node, children[i]},
                                  static_cast<std::uint32_t>(rooted.merged.nodes.size()));
            if (is_new) {
                rooted.merged.nodes.push_back({node.piece, node.weight, node.radius});
                all_children.push_back(children[i]);
            }
            tree.merged.push_back(place->second);
            if (node.parent != kNoIndex) children[node.parent].push_back(place->second);
        }
    }
    rooted.merged.shape = tree_shape(all_children);
}

GatheredNode component_root(const SkeletonDescriptor& descriptor, std::uint32_t graph_node,
                            double blob_weight) {
    GatheredNode node;
    node.graph_node = graph_node;
    node.radius = descriptor.nodes[graph_node].radius;
    node.weight = static_cast<float>(blob_weight * node.radius);
    return node;
}

float gap_between(const SkeletonDescriptor& descriptor, std::uint32_t a, std::uint32_t b) {
    const auto& p = descriptor.nodes[a].position;
    const auto& q = descriptor.nodes[b].position;
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

}  // namespace

RootedSkeletons root_skeleton(const SkeletonDescriptor& descriptor, const RootingOptions& options) {
    assert(options.candidate_roots >= 1 && options.max_pieces >= 1);
    RootedSkeletons rooted;
    if (descriptor.nodes.empty()) return rooted;
    const SkeletonAdjacency adjacency = skeleton_adjacency(descriptor);
    std::vector<Component> components =
        find_components(descriptor, adjacency, options.centrality_power);
    std::stable_sort(components.begin(), components.end(),
                     [](const Component& a, const Component& b) { return a.mass > b.mass; });
    for (std::size_t i = 0; i < components.size(); ++i) {
        const auto count = i == 0 ? static_cast<std::size_t>(options.candidate_roots) : 1;
        choose_roots(descriptor, adjacency, components[i], count, options.centrality_power);
    }
    PieceStore pieces(descriptor, rooted);
    for (const std::uint32_t root : components.front().roots) {
        Gathered gathered = {component_root(descriptor, root, options.root_blob_weight)};
        gather_component(descriptor, adjacency, 0, gathered);
        for (std::size_t i = 1; i < components.size(); ++i) {
            const std::uint32_t other = components[i].roots.front();
            const auto place = static_cast<std::uint32_t>(gathered.size());
            gathered.push_back(component_root(descriptor, other, options.root_blob_weight));
            gathered.back().parent = 0;
            gathered.back().root_distance = gap_between(descriptor, root, other);
            gather_component(descriptor, adjacency, place, gathered);
        }
        limit_size(gathered, static_cast<std::size_t>(options.max_pieces) + 1);
        rooted.trees.push_back(finish(std::move(gathered), pieces));
    }
    merge_trees(rooted);
    std::vector<std::span<const chain_code::DirectionStep>> codes;
    for (std::uint32_t i = 0; i < rooted.pieces.size(); ++i) codes.push_back(rooted.code(i));
    rooted.batch = chain_code::CodeBatch(codes);
    return rooted;
}

}  // namespace ossuary::matching
