#include "engine/skeleton/parallel_thinning.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "engine/skeleton/deletion_templates.h"
#include "engine/skeleton/p_simple.h"
#include "engine/voxel/border.h"

namespace ossuary {
namespace {

class ParallelThinning {
public:
    explicit ParallelThinning(const BitVolume& solid)
        : object_(solid),
          listed_(object_.shape()),
          exposed_(object_.shape()),
          candidates_(object_.shape()),
          steps_(object_.shape().neighbor_steps()) {
        for_each_voxel(border(solid), [&](const Vec3i& position) {
            const VoxelIndex v = object_.shape().index(position);
            exposed_.set(v);
            list(v);
        });
    }

    ThinningGrid run() {
        do {
            while (iterate()) {
            }
        } while (break_tie());
        return std::move(object_);
    }

private:
    void list(VoxelIndex v) {
        listed_.set(v);
        border_.push_back(v);
    }

    /// One pass over the simple points that face one side, the side that most can be deleted on.
    /// (Taking the sides in a fixed order instead eats a bar 4x4x100 from its end.)
    bool break_tie() {
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
            const auto kept = select_p_simple(facing);
            if (kept.size() > most.size()) most = kept;
        }
        for (const VoxelIndex v : border_) listed_.reset(v);
        border_.clear();
        remove(most);
        return !most.empty();
    }

    /// Those of `chosen` that are P-simple for P = `chosen`.
    std::vector<VoxelIndex> select_p_simple(const std::vector<VoxelIndex>& chosen) {
        for (const VoxelIndex v : chosen) candidates_.set(v);
        std::vector<VoxelIndex> selected;
        for (const VoxelIndex v : chosen) {
            if (is_p_simple(is_simple_, object_.neighborhood(v), candidates_.neighborhood(v))) {
                selected.push_back(v);
            }
        }
        for (const VoxelIndex v : chosen) candidates_.reset(v);
        return selected;
    }

    /// Deletes the P-simple points among the candidates on the list. The next list holds the
    /// candidates that stayed and all that lost a neighbour: nothing else can have changed.
    bool iterate() {
        chosen_.clear();
        for (const VoxelIndex v : border_) {
            listed_.reset(v);
            const Neighborhood around = object_.neighborhood(v);
            if (!is_tail(around) && matches_deletion_template(around)) chosen_.push_back(v);
        }
        border_ = chosen_;
        for (const VoxelIndex v : border_) listed_.set(v);
        const std::vector<VoxelIndex> deleted = select_p_simple(chosen_);
        remove(deleted);
        return !deleted.empty();
    }

    /// Deletes voxels and lists what is exposed around them.
    void remove(const std::vector<VoxelIndex>& voxels) {
        for (const VoxelIndex v : voxels) {
            object_.reset(v);
            for_each_bit(object_.neighborhood(v) & kFaceNeighbors, [&](int bit) {
                exposed_.set(moved(v, steps_[static_cast<std::size_t>(bit)]));
            });
        }
        for (const VoxelIndex v : voxels) {
            const Neighborhood fresh = object_.neighborhood(v) & exposed_.neighborhood(v) &
                                       ~listed_.neighborhood(v) & k26Neighbors;
            for_each_bit(fresh,
                         [&](int bit) { list(moved(v, steps_[static_cast<std::size_t>(bit)])); });
        }
        std::erase_if(border_, [&](VoxelIndex v) { return !object_.test(v); });
    }

    const SimplePointTest& is_simple_ = SimplePointTest::shared();
    ThinningGrid object_;
    ThinningGrid listed_;
    ThinningGrid exposed_;  ///< has had a background face: nothing else can be a candidate
    ThinningGrid candidates_;
    std::array<std::int32_t, 27> steps_;
    std::vector<VoxelIndex> border_;
    std::vector<VoxelIndex> chosen_;
};

}  // namespace

ThinningGrid thin_in_parallel(const BitVolume& solid) { return ParallelThinning(solid).run(); }

}  // namespace ossuary
