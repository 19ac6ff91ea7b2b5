#include "engine/matching/part_edit.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace ossuary::matching {

void PartEdit::sum_removals(const SampledTree& tree, float limit, Sides& sides) const {
    const std::size_t count = tree.nodes.size();
    sides.remove.resize(count);
    sides.whole.resize(count);
    sides.below.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        float sum = 0.0F;
        for (const std::uint32_t child : tree.shape.children(i)) sum += sides.whole[child];
        sides.remove[i] = removal_ * tree.nodes[i].length;
        sides.below[i] = sum;
        sides.whole[i] = std::min(limit, sum + sides.remove[i]);
    }
}

float PartEdit::rate(const SampledTree::Node& p, const SampledTree::Node& w) const {
    const float radius = radius_gain_ * std::abs(p.log_radius - w.log_radius);
    float rate = radius_weight_ * std::min(1.0F, radius);
    if (p.turn >= 0.0F && w.turn >= 0.0F) rate += turn_weight_ * std::abs(p.turn - w.turn);
    return std::min(rate, removal_);
}

PartEdit::Place PartEdit::solve(const SampledTree& part, const SampledTree& whole,
                                const PartEditCosts& costs) {
    assert(!part.tops.empty() && !whole.tops.empty());
    part_ = &part;
    whole_ = &whole;
    radius_weight_ = static_cast<float>(costs.radius_weight);
    radius_gain_ = static_cast<float>(0.5 * costs.radius_gain);
    turn_weight_ = static_cast<float>(costs.turn_weight);
    removal_ = static_cast<float>(costs.removal);
    sum_removals(part, std::numeric_limits<float>::infinity(), of_part_);
    sum_removals(whole, removal_ * static_cast<float>(costs.side_limb), of_whole_);
    const std::size_t rows = part.nodes.size();
    columns_ = whole.nodes.size();
    if (tree_.size() < rows * columns_) {
        tree_.resize(rows * columns_);
        forest_.resize(rows * columns_);
    }
    EditChoice ignored;
    for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t j = 0; j < columns_; ++j) {
            if (stop_.stop_requested()) return {};
            forest_[i * columns_ + j] = forest_cost(i, j, ignored);
            tree_[i * columns_ + j] = tree_cost(i, j, ignored);
        }
    }
    Place best;
    best.cost = std::numeric_limits<float>::infinity();
    for (std::uint32_t top = 0; top < part.tops.size() && !stop_.stop_requested(); ++top) {
        const auto offer = [&](Children children, std::uint32_t place, bool at_top) {
            const float cost = pair_children(part.tops[top].children, children, true, nullptr);
            if (cost < best.cost) best = {cost, top, place, at_top};
        };
        for (std::uint32_t i = 0; i < whole.tops.size(); ++i) {
            offer(whole.tops[i].children, i, true);
        }
        for (std::uint32_t j = 0; j < whole.nodes.size(); ++j) {
            offer(whole.shape.children(j), j, false);
        }
    }
    return best;
}

float PartEdit::tree_cost(std::size_t i, std::size_t j, EditChoice& choice) const {
    const SampledTree::Node& p = part_->nodes[i];
    const SampledTree::Node& w = whole_->nodes[j];
    float best = forest_[i * columns_ + j] + rate(p, w) * (p.length + w.length);
    choice = {EditChoice::kAcross, 0};
    const float all_but_j = of_whole_.remove[j] + of_whole_.below[j];
    for (const std::uint32_t child : whole_->shape.children(j)) {
        const float cost = (all_but_j - of_whole_.whole[child]) + tree_[i * columns_ + child];
        if (cost < best) {
            best = cost;
            choice = {EditChoice::kInto, child};
        }
    }
    for (const std::uint32_t child : part_->shape.children(i)) {
        const float cost =
            (of_part_.whole[i] - of_part_.whole[child]) + tree_[child * columns_ + j];
        if (cost < best) {
            best = cost;
            choice = {EditChoice::kOutOf, child};
        }
    }
    return best;
}

float PartEdit::forest_cost(std::size_t i, std::size_t j, EditChoice& choice) {
    choice = {EditChoice::kAcross, 0};
    const Children below_i = part_->shape.children(i);
    const Children below_j = whole_->shape.children(j);
    if (below_i.empty()) return of_whole_.below[j];
    if (below_j.empty()) return of_part_.below[i];
    float best = pair_children(below_i, below_j, false, nullptr);
    if (below_i.size() == 1 && below_j.size() == 1) return best;  // a pair of trees covers the rest
    for (const std::uint32_t child : below_j) {
        if (whole_->shape.children(child).empty()) continue;
        const float siblings = of_whole_.below[j] - of_whole_.whole[child];
        const float cost = siblings + of_whole_.remove[child] + forest_[i * columns_ + child];
        if (cost < best) {
            best = cost;
            choice = {EditChoice::kInto, child};
        }
    }
    for (const std::uint32_t child : below_i) {
        if (part_->shape.children(child).empty()) continue;
        const float cost =
            (of_part_.below[i] - of_part_.below[child]) + forest_[child * columns_ + j];
        if (cost < best) {
            best = cost;
            choice = {EditChoice::kOutOf, child};
        }
    }
    return best;
}

float PartEdit::pair_children(Children part, Children whole, bool free_rest,
                              std::vector<Pair>* pairs) {
    const auto cost_of_rest = [&](std::uint32_t j) {
        return free_rest ? 0.0F : of_whole_.whole[j];
    };
    if (part.size() == 1 && whole.size() == 1) {  // the inside of a branch: most of the work
        const float removed = of_part_.whole[part[0]] + cost_of_rest(whole[0]);
        const float exchanged = tree_[part[0] * columns_ + whole[0]];
        if (exchanged >= removed) return removed;
        if (pairs != nullptr) pairs->emplace_back(part[0], whole[0]);
        return exchanged;
    }
    const bool part_is_rows = part.size() <= whole.size();
    const Children rows = part_is_rows ? part : whole;
    const Children columns = part_is_rows ? whole : part;
    const auto pair_of = [&](std::size_t r, std::size_t c) {
        return part_is_rows ? Pair{rows[r], columns[c]} : Pair{columns[c], rows[r]};
    };
    // What an exchange saves against removing both; nothing where it costs more.
    gain_.resize(rows.size() * columns.size());
    for (std::size_t r = 0; r < rows.size(); ++r) {
        for (std::size_t c = 0; c < columns.size(); ++c) {
            const auto [i, j] = pair_of(r, c);
            const float removed = of_part_.whole[i] + cost_of_rest(j);
            gain_[r * columns.size() + c] = std::min(0.0F, tree_[i * columns_ + j] - removed);
        }
    }
    float cost = 0.0F;
    for (const std::uint32_t i : part) cost += of_part_.whole[i];
    for (const std::uint32_t j : whole) cost += cost_of_rest(j);
    const auto column_of_row = assignment_.solve(gain_, rows.size(), columns.size(), stop_);
    for (std::size_t r = 0; r < rows.size(); ++r) {
        const std::size_t c = column_of_row[r];
        const float gain = gain_[r * columns.size() + c];
        if (gain >= 0.0F) continue;
        cost += gain;
        if (pairs != nullptr) pairs->push_back(pair_of(r, c));
    }
    return std::max(0.0F, cost);
}

void PartEdit::exchanged(const SampledTree& part, const SampledTree& whole, const Place& place,
                         std::vector<Pair>& pairs) {
    pairs.clear();
    std::vector<Pair> tops;
    pair_children(part.tops[place.part_top].children,
                  place.at_top ? Children(whole.tops[place.whole_top].children)
                               : whole.shape.children(place.whole_top),
                  true, &tops);
    collect_exchanged(
        tops,
        [&](bool forest, std::uint32_t i, std::uint32_t j) {
            EditChoice choice;
            forest ? forest_cost(i, j, choice) : tree_cost(i, j, choice);
            return choice;
        },
        [&](std::uint32_t i, std::uint32_t j, std::vector<Pair>& children) {
            const Children below = part.shape.children(i), beside = whole.shape.children(j);
            if (!below.empty() && !beside.empty()) pair_children(below, beside, false, &children);
        },
        pairs);
}

}  // namespace ossuary::matching
