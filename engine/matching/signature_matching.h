#pragma once

#include <cstdint>
#include <stop_token>
#include <utility>
#include <vector>

#include "engine/matching/skeleton_descriptor.h"
#include "engine/matching/tree_edit.h"

namespace ossuary::matching {

/// Matched nodes of two skeletons' hierarchies, as indices into SignatureTree::nodes.
using NodePairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

struct SignatureMatchOptions {
    /// Beside the signatures' difference. First tier of the ten classes with 0, 1, 2 and 4: .400,
    /// .413, .417, .413.
    double significance_weight = 1.0;
};

/// Topology matching of thesis sec. 3.3.1. Keeps its buffers between calls.
class SignatureMatcher {
public:
    /// Once asked to stop, `match` returns soon with some of the pairs.
    explicit SignatureMatcher(std::stop_token stop = {}) : stop_(std::move(stop)) {}

    /// Matches the non-terminal nodes (Sundar, Silver, Gagvani, Dickinson, "Skeleton based shape
    /// matching and retrieval", SMI 2003, sec. 4): the cheapest pair first, then the nodes below
    /// the two, then the rest; a pair that would put a node above its matched ancestor is passed
    /// over. Then the end points below each matched pair, by subtree edit distance. Both steps give
    /// every node at most one partner.
    const NodePairs& match(const SkeletonDescriptor& a, const SkeletonDescriptor& b,
                           const SignatureMatchOptions& options);

private:
    using Node = std::uint32_t;
    void weigh_pairs(const SkeletonDescriptor& a, const SkeletonDescriptor& b,
                     double significance_weight);
    void match_inner_nodes(const SignatureTree& a, const SignatureTree& b);
    void match_end_points(const SkeletonDescriptor& a, const SkeletonDescriptor& b);
    [[nodiscard]] bool keeps_hierarchy(const SignatureTree& a, const SignatureTree& b, Node u,
                                       Node v) const;
    void join(Node u, Node v);

    std::stop_token stop_;
    NodePairs pairs_;
    std::vector<float> weight_;
    std::vector<Node> partner_a_, partner_b_;
    std::vector<float> remove_a_, remove_b_, exchange_;
    TreeEdit edit_;
    Assignment assignment_;
};

}  // namespace ossuary::matching
