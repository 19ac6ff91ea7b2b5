#include "engine/skeleton/parallel_thinning.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "engine/skeleton/deletion_templates.h"
#include "engine/skeleton/p_simple.h"
#include "engine/voxel/border.h"
#include "tests/support/shapes.h"

namespace ossuary::skeleton {
namespace {

using VoxelSet = std::set<VoxelIndex>;

/// Fully parallel thinning as it is defined, without remembering what cannot have changed: in each
/// iteration all that has lost a neighbour or was a candidate before is looked at.
class PlainThinning {
public:
    explicit PlainThinning(const voxel::BitVolume& solid) : object_(solid) {
        voxel::for_each_voxel(voxel::border(solid), [&](const Vec3i& position) {
            listed_.insert(object_.shape().index(position));
        });
    }

    ThinningGrid run() {
        do {
            while (iterate()) {
            }
        } while (break_tie());
        return object_;
    }

private:
    [[nodiscard]] VoxelSet removable(const VoxelSet& candidates) const {
        ThinningGrid set(object_.shape());
        for (const VoxelIndex v : candidates) set.set(v);
        VoxelSet result;
        for (const VoxelIndex v : candidates) {
            if (is_p_simple(is_simple_, object_.neighborhood(v), set.neighborhood(v))) {
                result.insert(v);
            }
        }
        return result;
    }

    bool iterate() {
        VoxelSet candidates;
        for (const VoxelIndex v : listed_) {
            const Neighborhood around = object_.neighborhood(v);
            if (!is_tail(around) && matches_deletion_template(around)) candidates.insert(v);
        }
        const VoxelSet deleted = removable(candidates);
        listed_ = candidates;
        remove(deleted);
        return !deleted.empty();
    }

    bool break_tie() {
        VoxelSet simple;
        object_.for_each([&](VoxelIndex v) {
            const Neighborhood around = object_.neighborhood(v);
            if (!is_tail(around) && is_simple_(around)) simple.insert(v);
        });
        VoxelSet most;
        for (const int bit : {22, 16, 14, 4, 10, 12}) {
            VoxelSet facing;
            for (const VoxelIndex v : simple) {
                if ((object_.neighborhood(v) >> bit & 1u) == 0) facing.insert(v);
            }
            VoxelSet kept = removable(facing);
            if (kept.size() > most.size()) most = std::move(kept);
        }
        listed_.clear();
        remove(most);
        return !most.empty();
    }

    void remove(const VoxelSet& voxels) {
        for (const VoxelIndex v : voxels) object_.reset(v);
        const auto steps = object_.shape().neighbor_steps();
        for (const VoxelIndex v : voxels) {
            listed_.erase(v);
            for_each_bit(object_.neighborhood(v), [&](int bit) {
                listed_.insert(moved(v, steps[static_cast<std::size_t>(bit)]));
            });
        }
    }

    const SimplePointTest& is_simple_ = SimplePointTest::shared();
    ThinningGrid object_;
    VoxelSet listed_;
};

TEST(ParallelThinning, IsWhatLookingAtEverythingAgainGives) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const std::array densities = {0.5, 0.8, 0.95, 0.99};
        const voxel::BitVolume solid = test::random_volume(
            {10 + static_cast<int>(seed % 13), 14, 12}, densities[seed % densities.size()], seed);
        ASSERT_EQ(thin_in_parallel(solid).volume(), PlainThinning(solid).run().volume()) << seed;
    }
    for (const test::VolumeShape& shape :
         {test::torus(), test::capsule_tree(), test::bar({6, 8, 50}), test::plate({30, 24, 4})}) {
        EXPECT_EQ(thin_in_parallel(shape.volume).volume(),
                  PlainThinning(shape.volume).run().volume())
            << shape.name;
    }
}

}  // namespace
}  // namespace ossuary::skeleton
