#include "engine/skeleton/anchors.h"

#include <cmath>
#include <limits>

#include "engine/skeleton/bucket_queue.h"
#include "engine/skeleton/component_centres.h"
#include "engine/skeleton/simple_point.h"

namespace ossuary {
namespace {

constexpr float kUnreached = std::numeric_limits<float>::infinity();

class AnchorSearch {
public:
    AnchorSearch(const BitVolume& solid, const DistanceField& distance,
                 const ThinningOptions& options)
        : options_(options),
          solid_(solid),
          steps_(solid_.shape().neighbor_steps()),
          centres_(component_centres(solid, distance)),
          squared_(solid_.shape().count(), 0),
          towards_centre_(solid_.shape().count(), kCentreBit),
          coverage_(solid_.shape().count(), kUnreached) {
        for (int z = 0; z < solid.size().z(); ++z) {
            for (int y = 0; y < solid.size().y(); ++y) {
                const std::uint32_t* row = distance.values().data() + distance.index({0, y, z});
                std::copy(row, row + solid.size().x(),
                          squared_.data() + solid_.shape().index(0, y, z));
            }
        }
        for (const ComponentCentre& centre : centres_) {
            largest_squared_ = std::max(largest_squared_, centre.squared_radius);
        }
    }

    Anchors run() {
        Anchors anchors{ThinningGrid(solid_.shape()), centres_.size(), 0, true};
        if (centres_.empty()) return anchors;
        find_paths();
        std::vector<VoxelIndex> path;
        for (const ComponentCentre& centre : centres_) {
            anchors.voxels.set(centre.voxel);
            path.push_back(centre.voxel);
        }
        BucketQueue queue(static_cast<std::size_t>(radius_cover(largest_squared_)) + 4);
        cover_from(path, queue);
        rank_uncovered();
        while (anchors.tips < options_.max_tips) {
            const auto [found, tip] = farthest();
            if (!found) break;
            path = path_from(tip, anchors.voxels);
            add_path(path, anchors);
            ++anchors.tips;
            cover_from(path, queue);
        }
        return anchors;
    }

private:
    [[nodiscard]] float radius_cover(std::uint32_t squared) const {
        return static_cast<float>(options_.radius_factor) * std::sqrt(static_cast<float>(squared));
    }

    /// Shortest paths from all centres at once; `towards_centre_` is the step back. A step costs
    /// its length times the mean of 1 / r^2 at its two ends.
    void find_paths() {
        const auto largest = static_cast<float>(largest_squared_);
        // Levels of the smallest step: whatever is served is final.
        const float levels_per_cost = largest;
        std::vector<float> cost(solid_.shape().count(), kUnreached);
        ThinningGrid open = solid_;
        BucketQueue queue(static_cast<std::size_t>(1.7321f * largest) + 4);
        queue.restart(0);
        for (const ComponentCentre& centre : centres_) {
            cost[centre.voxel] = 0.0f;
            queue.push(0, centre.voxel);
        }
        while (!queue.empty()) {
            const VoxelIndex v = queue.pop();
            if (!open.test(v)) continue;
            open.reset(v);
            const float here = cost[v];
            const float weight = 0.5f / static_cast<float>(squared_[v]);
            for_each_bit(open.neighborhood(v) & k26Neighbors, [&](int bit) {
                const auto b = static_cast<std::size_t>(bit);
                const VoxelIndex n = moved(v, steps_[b]);
                const float there =
                    here + kNeighborLength[b] * (weight + 0.5f / static_cast<float>(squared_[n]));
                if (there < cost[n]) {
                    cost[n] = there;
                    towards_centre_[n] = static_cast<std::uint8_t>(opposite_bit(bit));
                    queue.push(static_cast<std::uint64_t>(there * levels_per_cost), n);
                }
            });
        }
    }

    /// Lowers `coverage_` to what new path voxels give; only what improves is visited.
    void cover_from(const std::vector<VoxelIndex>& sources, BucketQueue& queue) {
        // Levels of one voxel, the shortest step; shifted so that none is negative.
        const float shift = radius_cover(largest_squared_) + 1.0f;
        queue.restart(0);
        for (const VoxelIndex v : sources) {
            const float value = -radius_cover(squared_[v]);
            if (value < coverage_[v]) {
                coverage_[v] = value;
                queue.push(static_cast<std::uint64_t>(value + shift), v);
            }
        }
        settled_.clear();
        ThinningGrid& open = solid_;
        while (!queue.empty()) {
            const VoxelIndex v = queue.pop();
            if (!open.test(v)) continue;
            open.reset(v);
            settled_.push_back(v);
            const float here = coverage_[v];
            for_each_bit(open.neighborhood(v) & k26Neighbors, [&](int bit) {
                const auto b = static_cast<std::size_t>(bit);
                const VoxelIndex n = moved(v, steps_[b]);
                const float there = here + kNeighborLength[b];
                if (there < coverage_[n]) {
                    coverage_[n] = there;
                    queue.push(static_cast<std::uint64_t>(there + shift), n);
                }
            });
        }
        for (const VoxelIndex v : settled_) solid_.set(v);
    }

    /// Lists the uncovered voxels by their coverage, one list for each voxel of distance.
    void rank_uncovered() {
        solid_.for_each([&](VoxelIndex v) { file(v); });
    }
    void file(VoxelIndex v) {
        const float excess = coverage_[v] - static_cast<float>(options_.coverage_voxels);
        if (excess <= 0.0f) return;
        const auto level = static_cast<std::size_t>(excess);
        if (level >= uncovered_.size()) uncovered_.resize(level + 1);
        uncovered_[level].push_back(v);
    }

    /// The voxel with the worst coverage, the first of equals. Coverage only falls, so lists hold
    /// voxels at or above their place and are sorted out when their turn comes.
    std::pair<bool, VoxelIndex> farthest() {
        while (!uncovered_.empty()) {
            std::vector<VoxelIndex> candidates = std::move(uncovered_.back());
            const std::size_t level = uncovered_.size() - 1;
            uncovered_.back().clear();
            for (const VoxelIndex v : candidates) file(v);
            const std::vector<VoxelIndex>& left = uncovered_[level];
            if (left.empty()) {
                uncovered_.pop_back();
                continue;
            }
            VoxelIndex best = left.front();
            for (const VoxelIndex v : left) {
                if (coverage_[v] > coverage_[best] ||
                    (coverage_[v] == coverage_[best] && v < best)) {
                    best = v;
                }
            }
            return {true, best};
        }
        return {false, 0};
    }

    /// From the first voxel next to the tree out to the tip, without detours: of the next steps the
    /// farthest that is still a neighbour is taken.
    std::vector<VoxelIndex> path_from(VoxelIndex tip, const ThinningGrid& tree) const {
        std::vector<VoxelIndex> path = {tip};
        while ((tree.neighborhood(path.back()) & k26Neighbors) == 0) {
            const VoxelIndex v = path.back();
            VoxelIndex next = moved(v, steps_[towards_centre_[v]]);
            VoxelIndex ahead = next;
            for (int look = 0; look < 3 && towards_centre_[ahead] != kCentreBit; ++look) {
                ahead = moved(ahead, steps_[towards_centre_[ahead]]);
                if (are_neighbors(v, ahead)) next = ahead;
            }
            path.push_back(next);
        }
        std::reverse(path.begin(), path.end());
        return path;
    }
    [[nodiscard]] bool are_neighbors(VoxelIndex a, VoxelIndex b) const {
        const auto step = static_cast<std::int32_t>(b - a);
        return std::find(steps_.begin(), steps_.end(), step) != steps_.end();
    }

    static void add_path(const std::vector<VoxelIndex>& path, Anchors& anchors) {
        const SimplePointTest& is_simple = SimplePointTest::shared();
        for (const VoxelIndex v : path) {
            if (!is_simple(anchors.voxels.neighborhood(v))) anchors.contractible = false;
            anchors.voxels.set(v);
        }
    }

    const ThinningOptions& options_;
    ThinningGrid solid_;
    std::array<std::int32_t, 27> steps_;
    std::vector<ComponentCentre> centres_;
    std::vector<std::uint32_t> squared_;  ///< distance to the background, squared
    std::vector<std::uint8_t> towards_centre_;
    std::vector<float> coverage_;
    std::vector<std::vector<VoxelIndex>> uncovered_;
    std::vector<VoxelIndex> settled_;
    std::uint32_t largest_squared_ = 0;
};

}  // namespace

Anchors find_anchors(const BitVolume& solid, const DistanceField& distance,
                     const ThinningOptions& options) {
    return AnchorSearch(solid, distance, options).run();
}

}  // namespace ossuary
