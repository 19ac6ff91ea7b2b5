#include "engine/skeleton/graph_surgery.h"

#include <algorithm>
#include <cassert>
#include <optional>

namespace ossuary::skeleton {
namespace {

using Branch = SkeletonGraph::Branch;
using Node = SkeletonGraph::Node;

void erase_branch(SkeletonGraph& graph, std::uint32_t branch) {
    graph.branches.erase(graph.branches.begin() + branch);
}

void erase_node(SkeletonGraph& graph, std::uint32_t node) {
    graph.nodes.erase(graph.nodes.begin() + node);
    for (Branch& branch : graph.branches) {
        assert(branch.a != node && branch.b != node);
        if (branch.a > node) --branch.a;
        if (branch.b > node) --branch.b;
    }
}

void reverse(Branch& branch) {
    std::swap(branch.a, branch.b);
    std::reverse(branch.points.begin(), branch.points.end());
    std::reverse(branch.radii.begin(), branch.radii.end());
}

/// Joins the two branches at a node of degree 2; nothing happens where they are one closed curve.
void dissolve(SkeletonGraph& graph, std::uint32_t node) {
    std::optional<std::uint32_t> first;
    std::optional<std::uint32_t> second;
    for (std::uint32_t i = 0; i < graph.branches.size(); ++i) {
        if (graph.branches[i].a != node && graph.branches[i].b != node) continue;
        (first ? second : first) = i;
    }
    if (!first || !second) return;
    Branch& in = graph.branches[*first];
    Branch& out = graph.branches[*second];
    if (in.a == node) reverse(in);
    if (out.b == node) reverse(out);
    in.b = out.b;
    in.points.insert(in.points.end(), out.points.begin() + 1, out.points.end());
    in.radii.insert(in.radii.end(), out.radii.begin() + 1, out.radii.end());
    erase_branch(graph, *second);
    erase_node(graph, node);
}

void move_node(SkeletonGraph& graph, std::uint32_t node, const Vec3& position, double radius) {
    graph.nodes[node].position = position;
    graph.nodes[node].radius = radius;
    for (Branch& branch : graph.branches) {
        if (branch.a == node) {
            branch.points.front() = position;
            branch.radii.front() = radius;
        }
        if (branch.b == node) {
            branch.points.back() = position;
            branch.radii.back() = radius;
        }
    }
}

}  // namespace

std::vector<Leaf> leaves(const SkeletonGraph& graph) {
    std::vector<Leaf> result;
    for (std::uint32_t i = 0; i < graph.branches.size(); ++i) {
        const Branch& branch = graph.branches[i];
        const int degree_a = graph.nodes[branch.a].degree;
        const int degree_b = graph.nodes[branch.b].degree;
        if (degree_a == 1 && degree_b > 1) result.push_back({i, branch.a, branch.b});
        if (degree_b == 1 && degree_a > 1) result.push_back({i, branch.b, branch.a});
    }
    return result;
}

void remove_leaf(SkeletonGraph& graph, const Leaf& leaf) {
    erase_branch(graph, leaf.branch);
    erase_node(graph, leaf.tip);
    const std::uint32_t junction = leaf.junction > leaf.tip ? leaf.junction - 1 : leaf.junction;
    if (--graph.nodes[junction].degree == 2) dissolve(graph, junction);
}

void join_degree_two_nodes(SkeletonGraph& graph) {
    update_degrees(graph);
    for (std::uint32_t node = 0; node < graph.nodes.size();) {
        const std::size_t before = graph.nodes.size();
        if (graph.nodes[node].degree == 2) dissolve(graph, node);
        if (graph.nodes.size() == before) ++node;
    }
}

void contract_branch(SkeletonGraph& graph, std::uint32_t branch) {
    const std::uint32_t kept = std::min(graph.branches[branch].a, graph.branches[branch].b);
    const std::uint32_t gone = std::max(graph.branches[branch].a, graph.branches[branch].b);
    assert(kept != gone);
    const Node& a = graph.nodes[kept];
    const Node& b = graph.nodes[gone];
    const double weight = a.radius + b.radius;
    const double share = weight > 0.0 ? a.radius / weight : 0.5;
    const Vec3 position = share * a.position + (1.0 - share) * b.position;
    const double radius = std::max(a.radius, b.radius);
    const int degree = a.degree + b.degree - 2;
    erase_branch(graph, branch);
    for (Branch& other : graph.branches) {
        if (other.a == gone) other.a = kept;
        if (other.b == gone) other.b = kept;
    }
    move_node(graph, kept, position, radius);
    graph.nodes[kept].degree = degree;
    erase_node(graph, gone);
}

}  // namespace ossuary::skeleton
