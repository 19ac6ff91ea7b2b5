#include "engine/matching/topological_signature.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cassert>
#include <tuple>

#include "engine/matching/skeleton_descriptor.h"
#include "engine/matching/skeleton_paths.h"

namespace ossuary::matching {
namespace {

/// Nodes from the most to the least significant.
std::vector<std::uint32_t> by_significance(const SkeletonDescriptor& descriptor) {
    std::vector<std::uint32_t> order(descriptor.nodes.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        const SkeletonDescriptor::Node& p = descriptor.nodes[a];
        const SkeletonDescriptor::Node& q = descriptor.nodes[b];
        return std::tie(p.significance, p.radius) > std::tie(q.significance, q.radius);
    });
    return order;
}

struct Hanging {
    std::vector<std::uint32_t> parent;  // graph nodes
    std::vector<std::uint32_t> parent_branch;
    std::vector<std::vector<std::uint32_t>> children;
};

Hanging hang_up(const SkeletonDescriptor& descriptor, const std::vector<std::uint32_t>& order) {
    const SkeletonAdjacency adjacency = skeleton_adjacency(descriptor);
    const std::size_t count = descriptor.nodes.size();
    Hanging hanging{std::vector<std::uint32_t>(count, kNoIndex),
                    std::vector<std::uint32_t>(count, kNoIndex),
                    std::vector<std::vector<std::uint32_t>>(count)};
    std::vector<bool> hung(count, false);
    for (const std::uint32_t root : order) {
        if (hung[root]) continue;
        if (root != order.front()) {
            hanging.parent[root] = order.front();
            hanging.children[order.front()].push_back(root);
        }
        const SkeletonPaths paths = shortest_paths(descriptor, adjacency, root);
        for (const std::uint32_t node : paths.order) {
            hung[node] = true;
            if (node == root) continue;
            const std::uint32_t index = paths.parent_branch[node];
            const SkeletonDescriptor::Branch& branch = descriptor.branches[index];
            hanging.parent_branch[node] = index;
            hanging.parent[node] = branch.a == node ? branch.b : branch.a;
            hanging.children[hanging.parent[node]].push_back(node);
        }
    }
    return hanging;
}

std::vector<float> signature_of(const TreeShape& shape, const std::vector<double>& sums,
                                std::uint32_t node) {
    std::vector<float> signature;
    if (shape.children(node).empty()) return signature;
    for (const std::uint32_t child : shape.children(node)) {
        signature.push_back(static_cast<float>(sums[child]));
    }
    std::sort(signature.begin(), signature.end(), std::greater<>());
    signature.insert(signature.begin(), static_cast<float>(sums[node]));
    return signature;
}

}  // namespace

double eigenvalue_sum(const TreeShape& tree, std::uint32_t node, int max_matrix_size) {
    const std::size_t k = tree.children(node).size();
    if (k == 0) return 0.0;
    std::vector<std::uint32_t> nodes = {node};
    std::vector<Eigen::Index> parent = {0};
    const auto limit = static_cast<std::size_t>(max_matrix_size);
    for (std::size_t i = 0; i < nodes.size() && nodes.size() < limit; ++i) {
        for (const std::uint32_t child : tree.children(nodes[i])) {
            if (nodes.size() == limit) break;
            nodes.push_back(child);
            parent.push_back(static_cast<Eigen::Index>(i));
        }
    }
    const auto size = static_cast<Eigen::Index>(nodes.size());
    Eigen::MatrixXd adjacency = Eigen::MatrixXd::Zero(size, size);
    for (Eigen::Index i = 1; i < size; ++i) {
        const Eigen::Index up = parent[static_cast<std::size_t>(i)];
        adjacency(i, up) = adjacency(up, i) = 1.0;
    }
    Eigen::VectorXd values =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(adjacency, Eigen::EigenvaluesOnly)
            .eigenvalues()
            .cwiseAbs();
    std::sort(values.data(), values.data() + size, std::greater<>());
    return values.head(std::min(size, static_cast<Eigen::Index>(k))).sum();
}

SignatureTree signature_tree(const SkeletonDescriptor& descriptor,
                             const SignatureOptions& options) {
    SignatureTree tree;
    if (descriptor.nodes.empty()) return tree;
    const std::vector<std::uint32_t> order = by_significance(descriptor);
    const Hanging hanging = hang_up(descriptor, order);

    // Pre-order with the children from the last to the first, reversed, is post-order.
    std::vector<std::uint32_t> post = {};
    std::vector<std::uint32_t> stack = {order.front()};
    while (!stack.empty()) {
        const std::uint32_t node = stack.back();
        stack.pop_back();
        post.push_back(node);
        for (const std::uint32_t child : hanging.children[node]) stack.push_back(child);
    }
    assert(post.size() == descriptor.nodes.size());
    std::reverse(post.begin(), post.end());

    std::vector<std::uint32_t> place(post.size());
    for (std::uint32_t i = 0; i < post.size(); ++i) place[post[i]] = i;
    tree.nodes.resize(post.size());
    std::vector<std::uint32_t> parents(post.size(), kNoIndex);
    for (std::uint32_t i = 0; i < post.size(); ++i) {
        SignatureTree::Node& node = tree.nodes[i];
        node.graph_node = post[i];
        node.parent_branch = hanging.parent_branch[post[i]];
        if (hanging.parent[post[i]] != kNoIndex) node.parent = place[hanging.parent[post[i]]];
        parents[i] = node.parent;
        node.first_in_subtree = i;
    }
    for (std::uint32_t i = 0; i + 1 < post.size(); ++i) {
        SignatureTree::Node& parent = tree.nodes[tree.nodes[i].parent];
        parent.first_in_subtree = std::min(parent.first_in_subtree, tree.nodes[i].first_in_subtree);
    }
    for (std::uint32_t i = 0; i < order.size(); ++i) tree.nodes[place[order[i]]].rank = i;
    tree.shape = tree_shape(parents);
    std::vector<double> sums;
    for (std::uint32_t i = 0; i < post.size(); ++i) {
        sums.push_back(eigenvalue_sum(tree.shape, i, options.max_matrix_size));
        tree.nodes[i].signature = signature_of(tree.shape, sums, i);
    }
    return tree;
}

}  // namespace ossuary::matching
