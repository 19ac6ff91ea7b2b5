#include "engine/matching/signature_matching.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "engine/matching/relative_difference.h"

namespace ossuary::matching {
namespace {

/// Euclidean distance of two signature vectors, the shorter filled up with zeros, over the sum of
/// their lengths: in [0, 1].
float signature_difference(const std::vector<float>& x, const std::vector<float>& y) {
    double difference = 0.0, length_x = 0.0, length_y = 0.0;
    for (std::size_t i = 0; i < std::max(x.size(), y.size()); ++i) {
        const double p = i < x.size() ? static_cast<double>(x[i]) : 0.0;
        const double q = i < y.size() ? static_cast<double>(y[i]) : 0.0;
        difference += (p - q) * (p - q);
        length_x += p * p;
        length_y += q * q;
    }
    const double sum = std::sqrt(length_x) + std::sqrt(length_y);
    return sum > 0.0 ? static_cast<float>(std::sqrt(difference) / sum) : 0.0F;
}

float significance(const SkeletonDescriptor& skeleton, std::uint32_t node) {
    return skeleton.nodes[skeleton.hierarchy.nodes[node].graph_node].significance;
}

std::uint32_t rank_difference(const SignatureTree& a, const SignatureTree& b, std::uint32_t u,
                              std::uint32_t v) {
    const std::uint32_t p = a.nodes[u].rank;
    const std::uint32_t q = b.nodes[v].rank;
    return p > q ? p - q : q - p;
}

bool is_below(const SignatureTree& tree, std::uint32_t node, std::uint32_t ancestor) {
    return node < ancestor && node >= tree.nodes[ancestor].first_in_subtree;
}

/// The root counts as an inner node even where it is the only one (a ring, a point).
bool is_end_point(const SignatureTree& tree, std::uint32_t node) {
    return tree.shape.children(node).empty() && node + 1 != tree.nodes.size();
}

}  // namespace

void SignatureMatcher::join(Node u, Node v) {
    partner_a_[u] = v;
    partner_b_[v] = u;
    pairs_.emplace_back(u, v);
}

void SignatureMatcher::weigh_pairs(const SkeletonDescriptor& a, const SkeletonDescriptor& b,
                                   double significance_weight) {
    const std::size_t columns = b.hierarchy.nodes.size();
    weight_.assign(a.hierarchy.nodes.size() * columns, 0.0F);
    const auto share = static_cast<float>(significance_weight);
    for (Node u = 0; u < a.hierarchy.nodes.size() && !stop_.stop_requested(); ++u) {
        if (is_end_point(a.hierarchy, u)) continue;
        for (Node v = 0; v < columns; ++v) {
            if (is_end_point(b.hierarchy, v)) continue;
            weight_[u * columns + v] =
                signature_difference(a.hierarchy.nodes[u].signature,
                                     b.hierarchy.nodes[v].signature) +
                share * relative_difference(significance(a, u), significance(b, v));
        }
    }
}

bool SignatureMatcher::keeps_hierarchy(const SignatureTree& a, const SignatureTree& b, Node u,
                                       Node v) const {
    return std::all_of(pairs_.begin(), pairs_.end(), [&](const auto& pair) {
        return is_below(a, u, pair.first) == is_below(b, v, pair.second) &&
               is_below(a, pair.first, u) == is_below(b, pair.second, v);
    });
}

void SignatureMatcher::match_inner_nodes(const SignatureTree& a, const SignatureTree& b) {
    // A stack of subtree pairs: the depth-first recursion. The pair on top is worked on until no
    // two nodes of its subtrees can be matched any more.
    std::vector<std::pair<Node, Node>> stack = {
        {static_cast<Node>(a.nodes.size() - 1), static_cast<Node>(b.nodes.size() - 1)}};
    while (!stack.empty()) {
        const auto [top_a, top_b] = stack.back();
        using Key = std::tuple<float, std::uint32_t, std::uint32_t, std::uint32_t>;
        Key best_key;
        Node best_u = kNoIndex, best_v = kNoIndex;
        for (Node u = a.nodes[top_a].first_in_subtree; u <= top_a; ++u) {
            if (stop_.stop_requested()) return;
            if (partner_a_[u] != kNoIndex || is_end_point(a, u)) continue;
            for (Node v = b.nodes[top_b].first_in_subtree; v <= top_b; ++v) {
                if (partner_b_[v] != kNoIndex || is_end_point(b, v)) continue;
                const Key key = {weight_[u * b.nodes.size() + v], rank_difference(a, b, u, v),
                                 a.nodes[u].rank, b.nodes[v].rank};
                if (best_u != kNoIndex && !(key < best_key)) continue;
                if (!keeps_hierarchy(a, b, u, v)) continue;
                best_key = key;
                best_u = u;
                best_v = v;
            }
        }
        if (best_u == kNoIndex) {
            stack.pop_back();
            continue;
        }
        join(best_u, best_v);
        stack.emplace_back(best_u, best_v);
    }
}

void SignatureMatcher::match_end_points(const SkeletonDescriptor& a, const SkeletonDescriptor& b) {
    const SignatureTree& ta = a.hierarchy;
    const SignatureTree& tb = b.hierarchy;
    remove_a_.clear();
    remove_b_.clear();
    exchange_.clear();
    for (Node u = 0; u < ta.nodes.size(); ++u) remove_a_.push_back(significance(a, u));
    for (Node v = 0; v < tb.nodes.size(); ++v) remove_b_.push_back(significance(b, v));
    for (const float p : remove_a_) {
        for (const float q : remove_b_) exchange_.push_back(std::abs(p - q));
    }
    edit_.solve({ta.shape, tb.shape, remove_a_, remove_b_, exchange_}, stop_);

    std::vector<Node> rows, columns;
    std::vector<float> costs;
    const std::size_t inner_pairs = pairs_.size();
    for (std::size_t k = 0; k < inner_pairs && !stop_.stop_requested(); ++k) {
        const auto [u, v] = pairs_[k];
        rows.clear();
        columns.clear();
        for (const Node c : ta.shape.children(u)) {
            if (is_end_point(ta, c) && partner_a_[c] == kNoIndex) rows.push_back(c);
        }
        for (const Node c : tb.shape.children(v)) {
            if (is_end_point(tb, c) && partner_b_[c] == kNoIndex) columns.push_back(c);
        }
        const bool transposed = rows.size() > columns.size();
        if (transposed) std::swap(rows, columns);
        costs.clear();
        for (const Node r : rows) {
            for (const Node c : columns) {
                const Node i = transposed ? c : r;
                const Node j = transposed ? r : c;
                // Between equals the nearer rank decides, so that a skeleton matches itself.
                const auto tie = 1e-6F * static_cast<float>(rank_difference(ta, tb, i, j));
                costs.push_back(edit_.distance(i, j) + tie);
            }
        }
        const auto column_of_row = assignment_.solve(costs, rows.size(), columns.size(), stop_);
        for (std::size_t r = 0; r < rows.size(); ++r) {
            const Node c = columns[column_of_row[r]];
            transposed ? join(c, rows[r]) : join(rows[r], c);
        }
    }
}

const NodePairs& SignatureMatcher::match(const SkeletonDescriptor& a, const SkeletonDescriptor& b,
                                         const SignatureMatchOptions& options) {
    pairs_.clear();
    partner_a_.assign(a.hierarchy.nodes.size(), kNoIndex);
    partner_b_.assign(b.hierarchy.nodes.size(), kNoIndex);
    if (a.hierarchy.nodes.empty() || b.hierarchy.nodes.empty()) return pairs_;
    weigh_pairs(a, b, options.significance_weight);
    match_inner_nodes(a.hierarchy, b.hierarchy);
    if (!stop_.stop_requested()) match_end_points(a, b);
    return pairs_;
}

}  // namespace ossuary::matching
