#include "engine/skeleton/parallel_thinning.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "engine/skeleton/deletion_templates.h"
#include "engine/skeleton/p_simple.h"
#include "engine/voxel/border.h"

namespace ossuary::skeleton {
namespace {

class ParallelThinning {
public:
    explicit ParallelThinning(const voxel::BitVolume& solid)
        : object_(solid),
          candidates_(object_.shape()),
          quiet_(object_),
          waits_(object_.shape()),
          turned_(object_.shape()),
          steps_(object_.shape().neighbor_steps()) {
        voxel::for_each_voxel(voxel::border(solid), [&](const Vec3i& position) {
            const VoxelIndex v = object_.shape().index(position);
            quiet_.reset(v);
            changed_.push_back(v);
        });
    }

    ThinningGrid run(const std::stop_token& stop) {
        do {
            while (!stop.stop_requested() && iterate()) {
            }
        } while (!stop.stop_requested() && break_tie());
        return std::move(object_);
    }

private:
    /// One pass over the simple points that face one side, the side that most can be deleted on.
    /// (Taking the sides in a fixed order instead eats a bar 4x4x100 from its end.) Afterwards only
    /// what is beside the deleted is looked at, and others are no candidates.
    bool break_tie() {
        for (const VoxelIndex v : waiting_) {
            waits_.reset(v);
            candidates_.reset(v);
        }
        waiting_.clear();
        std::vector<VoxelIndex> simple;
        object_.for_each([&](VoxelIndex v) {
            const Neighborhood around = object_.neighborhood(v);
            if (!is_tail(around) && is_simple_(around)) simple.push_back(v);
        });
        if (simple.empty()) return false;
        std::vector<VoxelIndex> most;
        for (const int bit : {22, 16, 14, 4, 10, 12}) {
            std::vector<VoxelIndex> facing;
            std::copy_if(simple.begin(), simple.end(), std::back_inserter(facing),
                         [&](VoxelIndex v) { return (object_.neighborhood(v) >> bit & 1u) == 0; });
            for (const VoxelIndex v : facing) candidates_.set(v);
            std::vector<VoxelIndex> kept;
            std::copy_if(facing.begin(), facing.end(), std::back_inserter(kept),
                         [&](VoxelIndex v) { return may_go(v); });
            for (const VoxelIndex v : facing) candidates_.reset(v);
            if (kept.size() > most.size()) most = std::move(kept);
        }
        remove(most);
        return !most.empty();
    }

    [[nodiscard]] bool may_go(VoxelIndex v) const {
        return is_p_simple(is_simple_, object_.neighborhood(v), candidates_.neighborhood(v));
    }

    /// Deletes those candidates that are P-simple for all candidates. A voxel is a candidate or not
    /// by its neighbourhood, and may go or not by that and which of it are candidates: only where
    /// one of them has changed it has to be looked at again.
    bool iterate() {
        to_test_.clear();
        turned_voxels_.clear();
        for (const VoxelIndex v : changed_) {
            const Neighborhood around = object_.neighborhood(v);
            const bool exposed = (around & kFaceNeighbors) != kFaceNeighbors;
            const bool candidate = exposed && !is_tail(around) && matches_deletion_template(around);
            if (candidate != candidates_.test(v)) turned_voxels_.push_back(v);
            if (candidate) {
                to_test_.push_back({v, around});
            } else {
                quiet_.set(v);
            }
        }
        changed_.clear();
        for (const VoxelIndex v : turned_voxels_) candidates_.flip(v);
        queue_beside_turned();
        deleted_.clear();
        for (const auto& [v, around] : to_test_) {
            if (is_p_simple(is_simple_, around, candidates_.neighborhood(v))) {
                deleted_.push_back(v);
                continue;
            }
            quiet_.set(v);
            if (waits_.test(v)) continue;
            waits_.set(v);
            waiting_.push_back(v);
        }
        remove(deleted_);
        return !deleted_.empty();
    }

    /// Adds the candidates with a neighbour that has become one or ceased to be one to those to
    /// test: from whichever side there are fewer to go through.
    void queue_beside_turned() {
        if (turned_voxels_.size() < waiting_.size() / 2) {
            for (const VoxelIndex v : turned_voxels_) {
                for_each_bit(candidates_.neighborhood(v) & quiet_.neighborhood(v),
                             [&](int bit) { queue(neighbor(v, bit)); });
            }
            return;
        }
        for (const VoxelIndex v : turned_voxels_) turned_.set(v);
        std::erase_if(waiting_, [&](VoxelIndex v) {
            if (candidates_.test(v) && quiet_.test(v)) {
                if (turned_.neighborhood(v) == 0) return false;
                queue(v);
            }
            waits_.reset(v);
            return true;
        });
        for (const VoxelIndex v : turned_voxels_) turned_.reset(v);
    }

    void queue(VoxelIndex candidate) {
        quiet_.reset(candidate);
        to_test_.push_back({candidate, object_.neighborhood(candidate)});
    }

    /// Deletes voxels and lists what has changed around them.
    void remove(const std::vector<VoxelIndex>& voxels) {
        for (const VoxelIndex v : voxels) {
            object_.reset(v);
            candidates_.reset(v);
            quiet_.reset(v);
        }
        for (const VoxelIndex v : voxels) {
            for_each_bit(quiet_.neighborhood(v), [&](int bit) {
                const VoxelIndex n = neighbor(v, bit);
                quiet_.reset(n);
                changed_.push_back(n);
            });
        }
    }

    [[nodiscard]] VoxelIndex neighbor(VoxelIndex v, int bit) const {
        return moved(v, steps_[static_cast<std::size_t>(bit)]);
    }

    struct Test {
        VoxelIndex voxel = 0;
        Neighborhood around = 0;
    };

    const SimplePointTest& is_simple_ = SimplePointTest::shared();
    ThinningGrid object_;
    ThinningGrid candidates_;
    ThinningGrid quiet_;   ///< of the object what is neither in `changed_` nor in `to_test_`
    ThinningGrid waits_;   ///< is in `waiting_`
    ThinningGrid turned_;  ///< empty but while it is used
    std::array<std::int32_t, 27> steps_;
    std::vector<VoxelIndex> changed_;  ///< have lost a neighbour
    std::vector<VoxelIndex> turned_voxels_;
    std::vector<Test> to_test_;
    std::vector<VoxelIndex> waiting_;  ///< all candidates that could not go, and some that are none
    std::vector<VoxelIndex> deleted_;
};

}  // namespace

ThinningGrid thin_in_parallel(const voxel::BitVolume& solid, const std::stop_token& stop) {
    return ParallelThinning(solid).run(stop);
}

}  // namespace ossuary::skeleton
