#include "engine/skeleton/tip_search.h"

#include <cmath>

#include "engine/skeleton/shortest_paths.h"
#include "engine/skeleton/voxel_map.h"

namespace ossuary {
namespace {

class TipSearch {
public:
    TipSearch(const BlockGrid& blocks, const std::vector<VoxelIndex>& centres, double coverage,
              const ThinningOptions& options)
        : blocks_(blocks),
          options_(options),
          enough_(static_cast<float>(coverage / blocks.edge())),
          steps_(blocks.shape().neighbor_steps()),
          open_(blocks.occupied()),
          coverage_(blocks.occupied(), kUnreached),
          centres_(centres) {
        for (const VoxelIndex centre : centres) {
            largest_cover_ = std::max(largest_cover_, radius_cover(centre));
        }
    }

    Tips run() {
        Tips tips{{}, ThinningGrid(blocks_.shape())};
        if (centres_.empty()) return tips;
        const ShortestPaths paths = shortest_paths(
            blocks_.occupied(), [&](VoxelIndex b) { return blocks_.links(b); },
            [&](VoxelIndex b) { return blocks_.squared_radius(b); }, centres_);
        for (const VoxelIndex centre : centres_) tips.tree.set(centre);
        BucketQueue queue(static_cast<std::size_t>(largest_cover_) + 4);
        cover_from(centres_, queue);
        rank_uncovered();
        while (static_cast<int>(tips.blocks.size()) < options_.max_tips) {
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
        // Levels of one block, the shortest step; shifted so that none is negative.
        const float shift = largest_cover_ + 1.0f;
        queue.restart(0);
        for (const VoxelIndex b : sources) {
            const float value = -radius_cover(b);
            if (value < coverage_[b]) {
                coverage_[b] = value;
                queue.push(static_cast<std::uint64_t>(value + shift), b);
            }
        }
        settled_.clear();
        while (!queue.empty()) {
            const VoxelIndex b = queue.pop();
            if (!open_.test(b)) continue;
            open_.reset(b);
            settled_.push_back(b);
            const float here = coverage_[b];
            for_each_bit(blocks_.links(b) & open_.neighborhood(b), [&](int bit) {
                const auto i = static_cast<std::size_t>(bit);
                const VoxelIndex n = moved(b, steps_[i]);
                const float there = here + kNeighborLength[i];
                if (there < coverage_[n]) {
                    coverage_[n] = there;
                    queue.push(static_cast<std::uint64_t>(there + shift), n);
                }
            });
        }
        for (const VoxelIndex b : settled_) open_.set(b);
    }

    /// Lists the uncovered blocks by their coverage, one list for each block of distance.
    void rank_uncovered() {
        blocks_.occupied().for_each([&](VoxelIndex b) { file(b); });
    }
    void file(VoxelIndex b) {
        const float excess = coverage_[b] - enough_;
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
            for (const VoxelIndex b : left) {
                if (coverage_[b] > coverage_[best] ||
                    (coverage_[b] == coverage_[best] && b < best)) {
                    best = b;
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
    ThinningGrid open_;  ///< what the running search may still visit
    VoxelMap<float> coverage_;
    const std::vector<VoxelIndex>& centres_;
    std::vector<std::vector<VoxelIndex>> uncovered_;
    std::vector<VoxelIndex> settled_;
    float largest_cover_ = 0.0f;
};

}  // namespace

Tips find_tips(const BlockGrid& blocks, const std::vector<VoxelIndex>& centres, double coverage,
               const ThinningOptions& options) {
    return TipSearch(blocks, centres, coverage, options).run();
}

}  // namespace ossuary
