#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

#include "engine/matching/assignment.h"
#include "engine/matching/edit_choices.h"
#include "engine/matching/tree_shape.h"

namespace ossuary::matching {

/// Two trees with the costs of editing one into the other. Costs are finite and not negative;
/// exchange(i, j) = exchange[i * b.size() + j] should not exceed remove_a[i] + remove_b[j].
struct TreeEditProblem {
    const TreeShape& a;
    const TreeShape& b;
    std::span<const float> remove_a;
    std::span<const float> remove_b;
    std::span<const float> exchange;
};

/// The constrained edit distance between unordered labelled trees (Zhang, Algorithmica 15, 1996):
/// nodes are exchanged, removed or inserted; the nodes exchanged keep their ancestors, and disjoint
/// subtrees go to disjoint subtrees. Keeps its buffers between calls.
class TreeEdit {
public:
    using Pair = std::pair<std::uint32_t, std::uint32_t>;

    /// Compares every subtree of a with every subtree of b. Once asked to stop, it returns soon,
    /// and what the others give then means nothing.
    void solve(const TreeEditProblem& problem, std::stop_token stop = {});

    /// The least cost of turning the subtree of a at node i into that of b at node j, in the last
    /// problem solved; 0 for equal subtrees, exactly.
    [[nodiscard]] float distance(std::size_t i, std::size_t j) const {
        return tree_[i * columns_ + j];
    }

    /// The nodes that the cheapest edit of these two subtrees exchanges, parents before children.
    /// @param problem  the last one solved
    void exchanged(const TreeEditProblem& problem, const Pair& roots, std::vector<Pair>& pairs);

private:
    /// `choice` becomes how the cheapest edit of a pair of (sub)trees or forests begins.
    float tree_cost(const TreeEditProblem& problem, std::size_t i, std::size_t j,
                    EditChoice& choice) const;
    float forest_cost(const TreeEditProblem& problem, std::size_t i, std::size_t j,
                      EditChoice& choice);
    /// Cheapest pairing of the children; appends the pairs where `pairs` is given.
    float pair_children(const TreeEditProblem& problem, std::size_t i, std::size_t j,
                        std::vector<Pair>* pairs);
    void sum_removals(const TreeShape& tree, std::span<const float> remove,
                      std::vector<float>& whole, std::vector<float>& below) const;

    std::stop_token stop_;
    std::size_t columns_ = 0;
    std::vector<float> whole_a_, below_a_;  // cost of removing a subtree, the forest below a node
    std::vector<float> whole_b_, below_b_;
    std::vector<float> tree_, forest_;
    std::vector<float> gain_;
    std::vector<char> taken_;
    Assignment assignment_;
};

}  // namespace ossuary::matching
