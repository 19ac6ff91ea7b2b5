#include "engine/decomposition/merge_patches.h"

#include <algorithm>
#include <limits>

#include "engine/decomposition/pair_features.h"
#include "engine/decomposition/segmentation.h"

namespace ossuary::decomposition {
namespace {

/// Parts that grow together; tables are count x count and symmetric.
class Merging {
public:
    Merging(const PatchGraph& graph, std::span<const float> together)
        : count_(graph.size()),
          linked_(count_ * count_, 0),
          gain_(count_ * count_, 0.0),
          size_(count_),
          best_(count_, 0) {
        for (std::size_t i = 0; i < count_; ++i) {
            size_[i] = static_cast<double>(graph.patches[i].triangles);
            parts_.push_back(i);
            for (const PatchGraph::Link& link : graph.links[i]) linked_[at(i, link.to)] = 1;
            for (std::size_t j = 0; j < i; ++j) {
                const auto probability = static_cast<double>(together[PatchPairs::index(j, i)]);
                const double gain = size_[j] * static_cast<double>(graph.patches[i].triangles) *
                                    (2.0 * probability - 1.0);
                gain_[at(i, j)] = gain_[at(j, i)] = gain;
            }
        }
        for (const std::size_t part : parts_) find_best(part);
    }

    struct Join {
        std::size_t into = 0;
        std::size_t from = 0;
        double gain = 0.0;
    };
    /// Joins the best two parts; `into` equals `from` when no two are linked.
    Join join_best() {
        Join join;
        double highest = -std::numeric_limits<double>::infinity();
        for (const std::size_t part : parts_) {
            const std::size_t other = best_[part];
            if (other == part || affinity(part, other) <= highest) continue;
            highest = affinity(part, other);
            join = {std::min(part, other), std::max(part, other), gain_[at(part, other)]};
        }
        if (join.into != join.from) unite(join.into, join.from);
        return join;
    }

private:
    [[nodiscard]] std::size_t at(std::size_t i, std::size_t j) const { return i * count_ + j; }
    [[nodiscard]] double affinity(std::size_t i, std::size_t j) const {
        return gain_[at(i, j)] / (size_[i] * size_[j]);
    }
    void find_best(std::size_t part) {
        best_[part] = part;
        double highest = -std::numeric_limits<double>::infinity();
        for (const std::size_t other : parts_) {
            if (other == part || linked_[at(part, other)] == 0) continue;
            if (affinity(part, other) <= highest) continue;
            highest = affinity(part, other);
            best_[part] = other;
        }
    }
    void unite(std::size_t into, std::size_t from) {
        parts_.erase(std::find(parts_.begin(), parts_.end(), from));
        for (const std::size_t other : parts_) {
            if (other == into) continue;
            gain_[at(into, other)] = gain_[at(other, into)] =
                gain_[at(into, other)] + gain_[at(from, other)];
            if (linked_[at(from, other)] != 0) {
                linked_[at(into, other)] = linked_[at(other, into)] = 1;
            }
        }
        size_[into] += size_[from];
        find_best(into);
        for (const std::size_t other : parts_) {
            if (other == into) continue;
            if (best_[other] == into || best_[other] == from) {
                find_best(other);
            } else if (linked_[at(other, into)] != 0 &&
                       (best_[other] == other ||
                        affinity(other, into) > affinity(other, best_[other]))) {
                best_[other] = into;
            }
        }
    }

    std::size_t count_;
    std::vector<std::uint8_t> linked_;
    std::vector<double> gain_;       ///< pairs of triangles put right less those put wrong
    std::vector<double> size_;       ///< triangles
    std::vector<std::size_t> best_;  ///< the linked part of highest affinity, itself if none is
    std::vector<std::size_t> parts_;
};

}  // namespace

std::vector<std::uint32_t> merge_patches(const PatchGraph& graph, std::span<const float> together,
                                         const MergePatchesOptions& options) {
    Merging merging(graph, together);
    std::vector<Merging::Join> joins;
    double sum = 0.0, best_sum = 0.0;
    std::size_t best_count = 0;
    for (;;) {
        const Merging::Join join = merging.join_best();
        if (join.into == join.from) break;
        joins.push_back(join);
        sum += join.gain;
        if (sum > best_sum) {
            best_sum = sum;
            best_count = joins.size();
        }
    }
    if (options.parts > 0) {
        best_count = graph.size() - std::min(options.parts, graph.size());
        best_count = std::min(best_count, joins.size());
    }
    std::vector<std::uint32_t> part(graph.size());
    for (std::uint32_t p = 0; p < part.size(); ++p) part[p] = p;
    for (std::size_t k = best_count; k-- > 0;) part[joins[k].from] = part[joins[k].into];
    return dense_segmentation(part).labels;
}

}  // namespace ossuary::decomposition
