#include "engine/matching/tree_edit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace ossuary::matching {
namespace {

using Parents = std::vector<std::uint32_t>;

Parents random_parents(std::mt19937& random, std::size_t count) {
    Parents parents(count, 0xFFFFFFFFU);
    for (std::size_t i = 0; i + 1 < count; ++i) {
        parents[i] = static_cast<std::uint32_t>(
            std::uniform_int_distribution<std::size_t>(i + 1, count - 1)(random));
    }
    return parents;
}

struct Trees {
    Parents parents_a, parents_b;
    TreeShape a, b;
    std::vector<float> remove_a, remove_b, exchange;
    [[nodiscard]] TreeEditProblem problem() const { return {a, b, remove_a, remove_b, exchange}; }
};

Trees random_trees(std::mt19937& random, std::size_t n, std::size_t m) {
    Trees t;
    t.parents_a = random_parents(random, n);
    t.parents_b = random_parents(random, m);
    t.a = tree_shape(t.parents_a);
    t.b = tree_shape(t.parents_b);
    std::uniform_real_distribution<float> cost(0.0F, 1.0F);
    for (std::size_t i = 0; i < n; ++i) t.remove_a.push_back(cost(random));
    for (std::size_t j = 0; j < m; ++j) t.remove_b.push_back(cost(random));
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < m; ++j) {
            t.exchange.push_back(cost(random) * (t.remove_a[i] + t.remove_b[j]));
        }
    }
    return t;
}

std::uint32_t common_ancestor(const Parents& parents, std::uint32_t x, std::uint32_t y) {
    while (x != y) {
        if (x < y) {
            x = parents[x];
        } else {
            y = parents[y];
        }
    }
    return x;
}

/// True where `ancestor` is above `node` and not the node itself.
bool is_above(const Parents& parents, std::uint32_t ancestor, std::uint32_t node) {
    while (node < ancestor) node = parents[node];
    return node == ancestor;
}
bool is_properly_above(const Parents& parents, std::uint32_t ancestor, std::uint32_t node) {
    return node != ancestor && is_above(parents, ancestor, node);
}

/// Zhang's condition: ancestors stay ancestors, and for any three pairs the common ancestor of two
/// nodes is a proper ancestor of the third on one side if and only if it is on the other.
bool is_constrained(const Trees& t, const std::vector<TreeEdit::Pair>& pairs) {
    for (const auto& [i1, j1] : pairs) {
        for (const auto& [i2, j2] : pairs) {
            if ((i1 == i2) != (j1 == j2)) return false;
            if (is_above(t.parents_a, i1, i2) != is_above(t.parents_b, j1, j2)) return false;
            for (const auto& [i3, j3] : pairs) {
                const bool above_a =
                    is_properly_above(t.parents_a, common_ancestor(t.parents_a, i1, i2), i3);
                const bool above_b =
                    is_properly_above(t.parents_b, common_ancestor(t.parents_b, j1, j2), j3);
                if (above_a != above_b) return false;
            }
        }
    }
    return true;
}

double cost_of(const Trees& t, const std::vector<TreeEdit::Pair>& pairs) {
    double cost = 0.0;
    std::vector<bool> kept_a(t.a.size(), false), kept_b(t.b.size(), false);
    for (const auto& [i, j] : pairs) {
        kept_a[i] = kept_b[j] = true;
        cost += static_cast<double>(t.exchange[i * t.b.size() + j]);
    }
    for (std::size_t i = 0; i < t.a.size(); ++i) {
        if (!kept_a[i]) cost += static_cast<double>(t.remove_a[i]);
    }
    for (std::size_t j = 0; j < t.b.size(); ++j) {
        if (!kept_b[j]) cost += static_cast<double>(t.remove_b[j]);
    }
    return cost;
}

/// The cheapest of all constrained mappings.
double try_all(const Trees& t, std::uint32_t i, std::vector<TreeEdit::Pair>& pairs) {
    if (i == t.a.size()) return is_constrained(t, pairs) ? cost_of(t, pairs) : 1e9;
    double best = try_all(t, i + 1, pairs);
    for (std::uint32_t j = 0; j < t.b.size(); ++j) {
        pairs.emplace_back(i, j);
        best = std::min(best, try_all(t, i + 1, pairs));
        pairs.pop_back();
    }
    return best;
}

float whole_distance(TreeEdit& edit, const Trees& t) {
    edit.solve(t.problem());
    return edit.distance(t.a.size() - 1, t.b.size() - 1);
}

TreeEdit::Pair roots(const Trees& t) {
    return {static_cast<std::uint32_t>(t.a.size() - 1), static_cast<std::uint32_t>(t.b.size() - 1)};
}

TEST(TreeShape, ListsTheChildrenOfEachNode) {
    const TreeShape shape = tree_shape(Parents{2, 2, 4, 4, 0xFFFFFFFFU});
    ASSERT_EQ(shape.size(), 5U);
    EXPECT_TRUE(shape.children(0).empty());
    ASSERT_EQ(shape.children(2).size(), 2U);
    EXPECT_EQ(shape.children(2)[1], 1U);
    EXPECT_EQ(shape.children(4)[0], 2U);
    EXPECT_EQ(tree_shape(Parents{}).size(), 0U);
}

TEST(TreeEdit, IsTheCheapestOfAllConstrainedMappings) {
    std::mt19937 random(51);
    TreeEdit edit;
    for (int round = 0; round < 250; ++round) {
        const Trees t = random_trees(random, 1 + static_cast<std::size_t>(round) % 5,
                                     1 + (static_cast<std::size_t>(round) / 5) % 5);
        std::vector<TreeEdit::Pair> pairs;
        EXPECT_NEAR(whole_distance(edit, t), try_all(t, 0, pairs), 1e-5);
    }
}

TEST(TreeEdit, NamesExchangesThatCostWhatItSays) {
    std::mt19937 random(52);
    TreeEdit edit;
    std::vector<TreeEdit::Pair> pairs;
    for (int round = 0; round < 300; ++round) {
        const Trees t = random_trees(random, 1 + static_cast<std::size_t>(round) % 17,
                                     1 + (static_cast<std::size_t>(round) * 7) % 19);
        const float distance = whole_distance(edit, t);
        edit.exchanged(t.problem(), roots(t), pairs);
        EXPECT_TRUE(is_constrained(t, pairs));
        EXPECT_NEAR(cost_of(t, pairs), distance, 1e-4);
    }
}

TEST(TreeEdit, IsExactlyZeroForATreeAndItsReorderedCopy) {
    std::mt19937 random(53);
    TreeEdit edit;
    for (int round = 0; round < 100; ++round) {
        Trees t = random_trees(random, 12, 12);
        t.parents_b = t.parents_a;
        t.a = t.b = tree_shape(t.parents_a);
        for (std::size_t i = 0; i < t.b.size(); ++i) {
            auto* children = t.b.child_nodes.data();
            std::reverse(children + t.b.child_begin[i], children + t.b.child_begin[i + 1]);
        }
        t.remove_b = t.remove_a;
        for (std::size_t i = 0; i < 12; ++i) {
            for (std::size_t j = 0; j < 12; ++j) {
                t.exchange[i * 12 + j] = i == j ? 0.0F : 0.5F * (t.remove_a[i] + t.remove_b[j]);
            }
        }
        EXPECT_EQ(whole_distance(edit, t), 0.0F);
    }
}

TEST(TreeEdit, ComparesTreesThatShareSubtreesLikeTreesOfTheirOwn) {
    // Two roots, 3 and 4, over the subtree at 2; node 4 has one leaf more.
    const TreeShape shared =
        tree_shape(std::vector<std::vector<std::uint32_t>>{{}, {}, {0, 1}, {2}, {0, 2}});
    const TreeShape apart = tree_shape(Parents{3, 3, 4, 4, 0xFFFFFFFFU});  // 0 is again at 2
    const std::vector<std::uint32_t> merged = {0, 1, 0, 2, 4};
    std::mt19937 random(55);
    TreeEdit edit;
    for (int round = 0; round < 50; ++round) {
        Trees t = random_trees(random, 5, 6);
        const TreeEditProblem all{shared, t.b, t.remove_a, t.remove_b, t.exchange};
        edit.solve(all);
        const float once = edit.distance(4, 5);
        std::vector<float> remove, exchange;
        for (const std::uint32_t node : merged) {
            remove.push_back(t.remove_a[node]);
            for (std::size_t j = 0; j < 6; ++j) exchange.push_back(t.exchange[node * 6 + j]);
        }
        const TreeEditProblem single{apart, t.b, remove, t.remove_b, exchange};
        edit.solve(single);
        EXPECT_NEAR(edit.distance(4, 5), once, 1e-5F);
    }
}

}  // namespace
}  // namespace ossuary::matching
