#include "engine/skeleton/tip_search.h"

#include <cmath>

#include "engine/skeleton/shortest_paths.h"

namespace ossuary::skeleton {
namespace {

class TipSearch {
public:
    TipSearch(const BlockGrid& blocks, const std::vector<VoxelIndex>& centres, double coverage,
              const ThinningOptions& options)
        : blocks_(blocks),
          options_(options),
          enough_(static_cast<float>(coverage / blocks.edge())),
          steps_(blocks.shape().neighbor_steps()),
          layout_(blocks.layout()),
          coverage_(layout_.count(), -kUnreached),
          settled_(layout_.count(), 0),
          centres_(centres) {
        blocks.occupied().for_each([&](VoxelIndex b) { coverage_[layout_.place(b)] = kUnreached; });
        for (const VoxelIndex centre : centres) {
            largest_cover_ = std::max(largest_cover_, radius_cover(centre));
        }
    }

    Tips run(const std::stop_token& stop) {
        Tips tips{{}, ThinningGrid(blocks_.shape())};
        if (centres_.empty()) return tips;
        const VoxelPaths paths = shortest_paths(
            blocks_.occupied(), [&](VoxelIndex b) { return blocks_.links(b); },
            [&](VoxelIndex b) { return blocks_.squared_radius(b); }, centres_, stop);
        if (stop.stop_requested()) return tips;
        for (const VoxelIndex centre : centres_) tips.tree.set(centre);
        BucketQueue queue(static_cast<std::size_t>(largest_cover_) + 4);
        cover_from(centres_, queue);
        rank_uncovered();
        while (static_cast<int>(tips.blocks.size()) < options_.max_tips && !stop.stop_requested()) {
            const auto [found, tip] = farthest();
            if (!found) break;
            tips.blocks.push_back(tip);
            std::vector<VoxelIndex> path;
            for (VoxelIndex b = tip; !tips.tree.test(b); b = paths.next(b, steps_)) {
                tips.tree.set(b);
                path.push_back(b);
            }
            cover_from(path, queue);
        }
        return tips;
    }

private:
    /// In blocks, like all lengths here.
    [[nodiscard]] float radius_cover(VoxelIndex block) const {
        return static_cast<float>(options_.radius_factor / blocks_.edge()) *
               std::sqrt(static_cast<float>(blocks_.squared_radius(block)));
    }

    /// Lowers `coverage_` to what new path blocks give; only what improves is visited.
    void cover_from(const std::vector<VoxelIndex>& sources, BucketQueue& queue) {
        // Levels of one block, the shortest step: whatever is served is final. Shifted so that none
        // is negative.
        const float shift = largest_cover_ + 1.0f;
        queue.restart(0);
        for (const VoxelIndex b : sources) {
            const float value = -radius_cover(b);
            float& coverage = coverage_[layout_.place(b)];
            if (value < coverage) {
                coverage = value;
                queue.push(BucketQueue::level_of(value + shift), b);
            }
        }
        settled_places_.clear();
        while (!queue.empty()) {
            const VoxelIndex b = queue.pop();
            const NeighborPlaces around(layout_, b);
            if (settled_[around.centre()] != 0) continue;
            settled_[around.centre()] = 1;
            settled_places_.push_back(around.centre());
            const float here = coverage_[around.centre()];
            Neighborhood nearer = 0;
            for (std::size_t r = 0; r < 9; ++r) {
                const float* row = coverage_.data() + around.row(r);
                nearer |=
                    (lanes_below(here + row_of_four(kRowLengths[r].data()), row_of_four(row)) & 7u)
                    << 3 * r;
            }
            for_each_bit(nearer & blocks_.links(b), [&](int bit) {
                const auto i = static_cast<std::size_t>(bit);
                const float there = here + kNeighborLength[i];
                coverage_[around.of(i)] = there;
                queue.push(BucketQueue::level_of(there + shift), moved(b, steps_[i]));
            });
        }
        for (const std::size_t place : settled_places_) settled_[place] = 0;
    }

    /// Lists the uncovered blocks by their coverage, one list for each block of distance.
    void rank_uncovered() {
        blocks_.occupied().for_each([&](VoxelIndex b) { file(b); });
    }
    void file(VoxelIndex b) {
        const float excess = coverage_[layout_.place(b)] - enough_;
        if (excess <= 0.0f) return;
        const auto level = static_cast<std::size_t>(excess);
        if (level >= uncovered_.size()) uncovered_.resize(level + 1);
        uncovered_[level].push_back(b);
    }

    /// The block with the worst coverage, the first of equals. Coverage only falls, so lists hold
    /// blocks at or above their place and are sorted out when their turn comes.
    std::pair<bool, VoxelIndex> farthest() {
        while (!uncovered_.empty()) {
            const std::vector<VoxelIndex> candidates = std::move(uncovered_.back());
            const std::size_t level = uncovered_.size() - 1;
            uncovered_.back().clear();
            for (const VoxelIndex b : candidates) file(b);
            const std::vector<VoxelIndex>& left = uncovered_[level];
            if (left.empty()) {
                uncovered_.pop_back();
                continue;
            }
            VoxelIndex best = left.front();
            float worst = coverage_[layout_.place(best)];
            for (const VoxelIndex b : left) {
                const float coverage = coverage_[layout_.place(b)];
                if (coverage > worst || (coverage == worst && b < best)) {
                    best = b;
                    worst = coverage;
                }
            }
            return {true, best};
        }
        return {false, 0};
    }

    const BlockGrid& blocks_;
    const ThinningOptions& options_;
    float enough_;  ///< the coverage asked for, in blocks
    std::array<std::int32_t, 27> steps_;
    const RowLayout& layout_;
    std::vector<float> coverage_;        ///< by place; nothing is an improvement outside the solid
    std::vector<std::uint8_t> settled_;  ///< by place: the running search is done with it
    std::vector<std::size_t> settled_places_;
    const std::vector<VoxelIndex>& centres_;
    std::vector<std::vector<VoxelIndex>> uncovered_;
    float largest_cover_ = 0.0f;
};

}  // namespace

Tips find_tips(const BlockGrid& blocks, const std::vector<VoxelIndex>& centres, double coverage,
               const ThinningOptions& options, const std::stop_token& stop) {
    return TipSearch(blocks, centres, coverage, options).run(stop);
}

}  // namespace ossuary::skeleton
