#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

#include "engine/matching/assignment.h"
#include "engine/matching/edit_choices.h"
#include "engine/matching/sampled_tree.h"

namespace ossuary::matching {

struct PartEditCosts {
    double radius_weight = 0.7;  ///< times min(1, radius_gain / 2 * |ln r - ln r'|)
    double radius_gain = 2.5;
    double turn_weight = 0.15;  ///< times the difference of turns, in half turns
    double removal = 0.6;       ///< of a piece without a partner, times its length
    /// What leaving out a limb of the whole costs at most, as the length of pieces removed.
    double side_limb = 0.15;
};

/// The constrained edit distance (Zhang, Algorithmica 15, 1996; see TreeEdit) of a part to the
/// connected piece of a whole that suits it best: what of the whole lies above that piece is free,
/// and a limb that leaves it sideways or goes on below costs a little and never more than
/// `side_limb`. Keeps its buffers between calls.
class PartEdit {
public:
    using Pair = std::pair<std::uint32_t, std::uint32_t>;

    struct Place {
        float cost = 0.0F;
        std::uint32_t part_top = 0;   ///< into part.tops
        std::uint32_t whole_top = 0;  ///< into whole.tops where `at_top`, else into whole.nodes
        bool at_top = false;
    };

    explicit PartEdit(std::stop_token stop = {}) : stop_(std::move(stop)) {}

    /// The cheapest place for the part; of equally cheap ones the first. Once asked to stop, it
    /// returns soon, and what it and the others give then means nothing.
    /// @pre both have a top
    Place solve(const SampledTree& part, const SampledTree& whole, const PartEditCosts& costs);

    /// The nodes that the cheapest edit at a place exchanges, parents before children, as (part's,
    /// whole's). @pre the trees of the last `solve`
    void exchanged(const SampledTree& part, const SampledTree& whole, const Place& place,
                   std::vector<Pair>& pairs);

    /// The cost of exchanging two pieces in the last problem solved, per unit of length.
    [[nodiscard]] float rate(const SampledTree::Node& p, const SampledTree::Node& w) const;

private:
    struct Sides {
        std::vector<float> remove, whole, below;
    };
    using Children = std::span<const std::uint32_t>;

    void sum_removals(const SampledTree& tree, float limit, Sides& sides) const;
    float tree_cost(std::size_t i, std::size_t j, EditChoice& choice) const;
    float forest_cost(std::size_t i, std::size_t j, EditChoice& choice);
    /// The cheapest pairing of pieces that begin at one place; those of the whole that are left
    /// over cost nothing where `free_rest`.
    float pair_children(Children part, Children whole, bool free_rest, std::vector<Pair>* pairs);

    std::stop_token stop_;
    const SampledTree* part_ = nullptr;
    const SampledTree* whole_ = nullptr;
    float radius_weight_ = 0.0F, radius_gain_ = 0.0F, turn_weight_ = 0.0F, removal_ = 0.0F;
    std::size_t columns_ = 0;
    Sides of_part_, of_whole_;  // `whole` is capped for the whole's limbs
    std::vector<float> tree_, forest_;
    std::vector<float> gain_;
    std::vector<char> taken_;
    Assignment assignment_;
};

}  // namespace ossuary::matching
