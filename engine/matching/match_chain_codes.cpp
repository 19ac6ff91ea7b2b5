#include "engine/matching/match_chain_codes.h"

#include <algorithm>
#include <cmath>

#include "engine/chain_code/stretch_twist.h"
#include "engine/matching/node_clusters.h"
#include "engine/matching/signature_matching.h"

namespace ossuary::matching {

struct ChainCodeMatchWorkspace::Buffers {
    explicit Buffers(std::stop_token asked) : stop(std::move(asked)), matcher(stop) {}

    std::stop_token stop;
    SignatureMatcher matcher;
    std::vector<std::uint32_t> partner;  // of a's graph nodes
    std::vector<std::uint32_t> tree_partner;
    std::vector<char> used_a, used_b;  // branches
    std::vector<Correspondence::Pair> branches;
};

ChainCodeMatchWorkspace::ChainCodeMatchWorkspace(std::stop_token stop)
    : buffers_(std::make_unique<Buffers>(std::move(stop))) {}
ChainCodeMatchWorkspace::~ChainCodeMatchWorkspace() = default;
ChainCodeMatchWorkspace::ChainCodeMatchWorkspace(ChainCodeMatchWorkspace&&) noexcept = default;
ChainCodeMatchWorkspace& ChainCodeMatchWorkspace::operator=(ChainCodeMatchWorkspace&&) noexcept =
    default;

namespace {

using Buffers = ChainCodeMatchWorkspace::Buffers;

double code_distance(const SkeletonDescriptor& a, const SkeletonDescriptor& b,
                     std::uint32_t branch_a, std::uint32_t branch_b) {
    return chain_code::stretch_twist(a.branches[branch_a].chain_code,
                                     b.branches[branch_b].chain_code)
        .distance();
}

void take(Buffers& buffers, const Correspondence::Pair& pair) {
    buffers.used_a[pair.a] = 1;
    buffers.used_b[pair.b] = 1;
    buffers.branches.push_back(pair);
}

/// Branches of the two hierarchies whose both ends are matched.
void match_tree_branches(const SkeletonDescriptor& a, const SkeletonDescriptor& b,
                         const NodePairs& pairs, Buffers& buffers) {
    for (const auto& [u, v] : pairs) {
        if (buffers.stop.stop_requested()) return;
        const SignatureTree::Node& from = a.hierarchy.nodes[u];
        const SignatureTree::Node& to = b.hierarchy.nodes[v];
        if (from.parent_branch == kNoIndex || to.parent_branch == kNoIndex) continue;
        if (buffers.tree_partner[from.parent] != to.parent) continue;
        take(buffers, {from.parent_branch, to.parent_branch,
                       code_distance(a, b, from.parent_branch, to.parent_branch)});
    }
}

/// Branches that close cycles between matched nodes, each with the nearest by code.
void match_cycle_branches(const SkeletonDescriptor& a, const SkeletonDescriptor& b,
                          Buffers& buffers) {
    for (std::uint32_t i = 0; i < a.branches.size(); ++i) {
        if (buffers.stop.stop_requested()) return;
        if (buffers.used_a[i] != 0) continue;
        const std::uint32_t first = buffers.partner[a.branches[i].a];
        const std::uint32_t second = buffers.partner[a.branches[i].b];
        if (first == kNoIndex || second == kNoIndex) continue;
        Correspondence::Pair best{i, kNoIndex, 0.0};
        for (std::uint32_t j = 0; j < b.branches.size(); ++j) {
            const SkeletonDescriptor::Branch& other = b.branches[j];
            const bool joins_same =
                (other.a == first && other.b == second) || (other.a == second && other.b == first);
            if (buffers.used_b[j] != 0 || !joins_same) continue;
            const double cost = code_distance(a, b, i, j);
            if (best.b == kNoIndex || cost < best.cost) best = {i, j, cost};
        }
        if (best.b != kNoIndex) take(buffers, best);
    }
}

struct Score {
    double distance = 0.0;
    double matched = 0.0;  ///< share of the distance from matched branches
};

/// Leaves the matched nodes in the matcher's pairs and the matched branches in `buffers`.
Score compare(const SkeletonDescriptor& a, const SkeletonDescriptor& b,
              const ChainCodeMatchOptions& options, Buffers& buffers, const NodePairs*& pairs) {
    pairs = &buffers.matcher.match(a, b, {options.significance_weight});
    buffers.partner.assign(a.nodes.size(), kNoIndex);
    buffers.tree_partner.assign(a.nodes.size(), kNoIndex);
    for (const auto& [u, v] : *pairs) {
        buffers.partner[a.hierarchy.nodes[u].graph_node] = b.hierarchy.nodes[v].graph_node;
        buffers.tree_partner[u] = v;
    }
    buffers.used_a.assign(a.branches.size(), 0);
    buffers.used_b.assign(b.branches.size(), 0);
    buffers.branches.clear();
    match_tree_branches(a, b, *pairs, buffers);
    match_cycle_branches(a, b, buffers);

    double matched = 0.0;
    for (const Correspondence::Pair& pair : buffers.branches) matched += pair.cost;
    const auto pairs_count = static_cast<double>(buffers.branches.size());
    const double unmatched =
        static_cast<double>(a.branches.size() + b.branches.size()) - 2.0 * pairs_count;
    const double count = options.sum ? 1.0 : pairs_count + unmatched;
    // Skeletons without branches: a point is like a point; nothing else is like nothing.
    if (pairs_count + unmatched == 0.0) {
        return {a.nodes.empty() == b.nodes.empty() ? 0.0 : 1.0, 0.0};
    }
    return {(matched + unmatched) / count, matched / count};
}

/// A fixed order of the arguments makes the greedy choice, and so the distance, symmetric.
bool is_in_order(const SkeletonDescriptor& a, const SkeletonDescriptor& b) {
    return in_order(a.rooted, b.rooted);
}

std::vector<std::uint32_t> cluster_sizes(const SignatureTree& a, const SignatureTree& b,
                                         const NodePairs& pairs) {
    NodeClusters clusters(a.nodes.size());
    std::vector<std::uint32_t> partner(a.nodes.size(), kNoIndex);
    for (const auto& [u, v] : pairs) {
        clusters.add(u);
        partner[u] = v;
    }
    for (const auto& [u, v] : pairs) {
        if (a.nodes[u].parent_branch == kNoIndex || b.nodes[v].parent_branch == kNoIndex) continue;
        if (partner[a.nodes[u].parent] == b.nodes[v].parent) clusters.join(u, a.nodes[u].parent);
    }
    return clusters.sizes();
}

}  // namespace

double chain_code_distance(const SkeletonDescriptor& a, const SkeletonDescriptor& b,
                           const ChainCodeMatchOptions& options,
                           ChainCodeMatchWorkspace& workspace) {
    const NodePairs* pairs = nullptr;
    return is_in_order(a, b) ? compare(a, b, options, workspace.buffers(), pairs).distance
                             : compare(b, a, options, workspace.buffers(), pairs).distance;
}

Match match_chain_codes(const SkeletonDescriptor& a, const SkeletonDescriptor& b,
                        const ChainCodeMatchOptions& options, const std::stop_token& stop) {
    if (!is_in_order(a, b)) {
        Match match = match_chain_codes(b, a, options, stop);
        for (auto* pairs : {&match.correspondence.nodes, &match.correspondence.branches}) {
            for (Correspondence::Pair& pair : *pairs) std::swap(pair.a, pair.b);
        }
        return match;
    }
    ChainCodeMatchWorkspace workspace(stop);
    Buffers& buffers = workspace.buffers();
    const NodePairs* pairs = nullptr;
    const Score score = compare(a, b, options, buffers, pairs);
    Match match;
    match.distance = score.distance;
    match.parts = {{"matched_branches", score.matched},
                   {"unmatched_branches", score.distance - score.matched}};
    for (const auto& [u, v] : *pairs) {
        const std::uint32_t i = a.hierarchy.nodes[u].graph_node;
        const std::uint32_t j = b.hierarchy.nodes[v].graph_node;
        const double cost = std::abs(static_cast<double>(a.nodes[i].significance) -
                                     static_cast<double>(b.nodes[j].significance));
        match.correspondence.nodes.push_back({i, j, cost});
    }
    match.correspondence.branches = buffers.branches;
    match.correspondence.cluster_sizes = cluster_sizes(a.hierarchy, b.hierarchy, *pairs);
    return match;
}

}  // namespace ossuary::matching
