#include "engine/matching/tree_edit.h"

#include <algorithm>
#include <cassert>

namespace ossuary::matching {

void TreeEdit::sum_removals(const TreeShape& tree, std::span<const float> remove,
                            std::vector<float>& whole, std::vector<float>& below) const {
    whole.resize(tree.size());
    below.resize(tree.size());
    for (std::size_t i = 0; i < tree.size(); ++i) {
        float sum = 0.0F;
        for (const std::uint32_t child : tree.children(i)) sum += whole[child];
        below[i] = sum;
        whole[i] = sum + remove[i];
    }
}

void TreeEdit::solve(const TreeEditProblem& problem, std::stop_token stop) {
    stop_ = std::move(stop);
    const std::size_t rows = problem.a.size();
    columns_ = problem.b.size();
    assert(problem.remove_a.size() == rows && problem.remove_b.size() == columns_);
    assert(problem.exchange.size() >= rows * columns_);
    sum_removals(problem.a, problem.remove_a, whole_a_, below_a_);
    sum_removals(problem.b, problem.remove_b, whole_b_, below_b_);
    if (tree_.size() < rows * columns_) {
        tree_.resize(rows * columns_);
        forest_.resize(rows * columns_);
    }
    EditChoice ignored;
    for (std::size_t i = 0; i < rows && !stop_.stop_requested(); ++i) {
        const bool a_is_leaf = problem.a.children(i).empty();
        for (std::size_t j = 0; j < columns_; ++j) {
            const std::size_t at = i * columns_ + j;
            if (a_is_leaf && problem.b.children(j).empty()) {
                forest_[at] = 0.0F;
                tree_[at] = problem.exchange[at];
                continue;
            }
            if (stop_.stop_requested()) return;  // a pair of hubs takes long by itself
            forest_[at] = forest_cost(problem, i, j, ignored);
            tree_[at] = tree_cost(problem, i, j, ignored);
        }
    }
}

float TreeEdit::tree_cost(const TreeEditProblem& problem, std::size_t i, std::size_t j,
                          EditChoice& choice) const {
    float best = forest_[i * columns_ + j] + problem.exchange[i * columns_ + j];
    choice = {EditChoice::kAcross, 0};
    for (const std::uint32_t child : problem.b.children(j)) {
        // Everything of j's subtree goes but the child's. A difference of sums that contain each
        // other never turns negative.
        const float cost = (whole_b_[j] - whole_b_[child]) + tree_[i * columns_ + child];
        if (cost < best) {
            best = cost;
            choice = {EditChoice::kInto, child};
        }
    }
    for (const std::uint32_t child : problem.a.children(i)) {
        const float cost = (whole_a_[i] - whole_a_[child]) + tree_[child * columns_ + j];
        if (cost < best) {
            best = cost;
            choice = {EditChoice::kOutOf, child};
        }
    }
    return best;
}

float TreeEdit::forest_cost(const TreeEditProblem& problem, std::size_t i, std::size_t j,
                            EditChoice& choice) {
    choice = {EditChoice::kAcross, 0};
    const auto children_a = problem.a.children(i);
    const auto children_b = problem.b.children(j);
    if (children_a.empty()) return below_b_[j];
    if (children_b.empty()) return below_a_[i];
    float best = pair_children(problem, i, j, nullptr);
    for (const std::uint32_t child : children_b) {
        if (problem.b.children(child).empty()) continue;
        const float cost = (below_b_[j] - below_b_[child]) + forest_[i * columns_ + child];
        if (cost < best) {
            best = cost;
            choice = {EditChoice::kInto, child};
        }
    }
    for (const std::uint32_t child : children_a) {
        if (problem.a.children(child).empty()) continue;
        const float cost = (below_a_[i] - below_a_[child]) + forest_[child * columns_ + j];
        if (cost < best) {
            best = cost;
            choice = {EditChoice::kOutOf, child};
        }
    }
    return best;
}

float TreeEdit::pair_children(const TreeEditProblem& problem, std::size_t i, std::size_t j,
                              std::vector<Pair>* pairs) {
    const auto children_a = problem.a.children(i);
    const auto children_b = problem.b.children(j);
    const bool a_is_rows = children_a.size() <= children_b.size();
    const auto rows = a_is_rows ? children_a : children_b;
    const auto columns = a_is_rows ? children_b : children_a;
    const auto& whole_rows = a_is_rows ? whole_a_ : whole_b_;
    const auto& whole_columns = a_is_rows ? whole_b_ : whole_a_;
    const auto exchange = [&](std::uint32_t row, std::uint32_t column) {
        return a_is_rows ? tree_[row * columns_ + column] : tree_[column * columns_ + row];
    };
    // What an exchange saves against removing both; nothing where it costs more.
    gain_.resize(rows.size() * columns.size());
    for (std::size_t r = 0; r < rows.size(); ++r) {
        for (std::size_t c = 0; c < columns.size(); ++c) {
            const float removal = whole_rows[rows[r]] + whole_columns[columns[c]];
            gain_[r * columns.size() + c] = std::min(0.0F, exchange(rows[r], columns[c]) - removal);
        }
    }
    const auto column_of_row = assignment_.solve(gain_, rows.size(), columns.size(), stop_);
    taken_.assign(columns.size(), 0);
    float cost = 0.0F;
    for (std::size_t r = 0; r < rows.size(); ++r) {
        const std::size_t c = column_of_row[r];
        if (gain_[r * columns.size() + c] < 0.0F) {
            taken_[c] = 1;
            cost += exchange(rows[r], columns[c]);
            if (pairs != nullptr) {
                pairs->push_back(a_is_rows ? Pair{rows[r], columns[c]} : Pair{columns[c], rows[r]});
            }
        } else {
            cost += whole_rows[rows[r]];
        }
    }
    for (std::size_t c = 0; c < columns.size(); ++c) {
        if (taken_[c] == 0) cost += whole_columns[columns[c]];
    }
    return cost;
}

void TreeEdit::exchanged(const TreeEditProblem& problem, const Pair& roots,
                         std::vector<Pair>& pairs) {
    pairs.clear();
    collect_exchanged(
        {roots},
        [&](bool forest, std::uint32_t i, std::uint32_t j) {
            EditChoice choice;
            forest ? forest_cost(problem, i, j, choice) : tree_cost(problem, i, j, choice);
            return choice;
        },
        [&](std::uint32_t i, std::uint32_t j, std::vector<Pair>& children) {
            if (problem.a.children(i).empty() || problem.b.children(j).empty()) return;
            pair_children(problem, i, j, &children);
        },
        pairs);
}

}  // namespace ossuary::matching
