#include "engine/skeleton/peel.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "engine/skeleton/padded_distance.h"
#include "engine/skeleton/simple_point.h"
#include "engine/voxel/border.h"

namespace ossuary::skeleton {
namespace {

class Peeling {
public:
    Peeling(const voxel::BitVolume& solid, const voxel::DistanceField& distance,
            const ThinningGrid& keep)
        : object_(solid),
          fresh_(object_),
          idle_(object_.shape()),
          near_idle_(object_.shape()),
          depth_(distance, object_.shape()),
          steps_(object_.shape().neighbor_steps()) {
        for (int bit = 0; bit < 27; ++bit) {
            const NeighborOffset o = neighbor_offset(bit);
            row_steps_[static_cast<std::size_t>(bit)] =
                o.dz * static_cast<std::int32_t>(depth_.rows_in_plane()) + o.dy;
        }
        keep.for_each([&](VoxelIndex v) { fresh_.reset(v); });
        voxel::for_each_voxel(voxel::border(solid), [&](const Vec3i& position) {
            const VoxelIndex v = object_.shape().index(position);
            if (!fresh_.test(v)) return;
            fresh_.reset(v);
            enqueue(v, depth_.squared(v));
        });
    }

    ThinningGrid run(const std::stop_token& stop) {
        // Within a level in waves from the border inwards, so that what has one depth throughout,
        // such as a plate, shrinks evenly from all sides.
        std::vector<VoxelIndex> wave;
        for (std::size_t level = 0; level < levels_.size(); ++level) {
            while (!levels_[level].empty()) {
                if (stop.stop_requested()) return std::move(object_);
                wave.clear();
                std::swap(wave, levels_[level]);
                for (const VoxelIndex v : wave) {
                    visit(v);
                    enqueue_exposed(kOnTheWay, level);
                }
                enqueue_exposed(0, level);
            }
        }
        return std::move(object_);
    }

private:
    struct Exposed {
        VoxelIndex voxel = 0;
        const std::uint32_t* depth = nullptr;
    };
    static constexpr std::size_t kOnTheWay = 16;
    /// Of what has had its turn before: it is no deeper than the level.
    static constexpr std::uint32_t kNoDepth = 0;

    void enqueue(VoxelIndex v, std::size_t level) {
        if (level >= levels_.size()) levels_.resize(level + 1);
        levels_[level].push_back(v);
    }

    /// Puts what has been exposed in its level, all but the last few: their depths are still on the
    /// way from memory. (Waiting for each took two thirds of the time at 512 voxels.)
    void enqueue_exposed(std::size_t but, std::size_t level) {
        for (; exposed_.size() - next_exposed_ > but; ++next_exposed_) {
            const Exposed& e = exposed_[next_exposed_];
            enqueue(e.voxel, std::max<std::size_t>(*e.depth, level));
        }
        if (but > 0) return;
        exposed_.clear();
        next_exposed_ = 0;
    }

    void rest(VoxelIndex v) {
        idle_.set(v);
        for (const std::int32_t step : steps_) near_idle_.set(moved(v, step));
    }

    void visit(VoxelIndex v) {
        if (!is_simple_(object_.neighborhood(v))) {
            rest(v);
            return;
        }
        object_.reset(v);
        const Neighborhood idle = near_idle_.test(v) ? idle_.neighborhood(v) : 0;
        const std::uint32_t row = depth_.row_of(v);
        for_each_bit(idle | fresh_.face_neighbors(v), [&](int bit) {
            const auto b = static_cast<std::size_t>(bit);
            const VoxelIndex n = moved(v, steps_[b]);
            if ((idle >> bit & 1u) != 0) {
                idle_.reset(n);
                exposed_.push_back({n, &kNoDepth});
                return;
            }
            fresh_.reset(n);
            const std::uint32_t* depth =
                depth_.place_of(n, row + static_cast<std::uint32_t>(row_steps_[b]));
            __builtin_prefetch(depth);
            exposed_.push_back({n, depth});
        });
    }

    const SimplePointTest& is_simple_ = SimplePointTest::shared();
    ThinningGrid object_;
    /// What may go and never had a background face, so that it cannot be simple. (A set for each of
    /// border, queue and keep, looked at together, took half as long again.)
    ThinningGrid fresh_;
    ThinningGrid idle_;  ///< was not simple when its turn came
    /// Neighbours of what was ever idle, a few in a thousand: one look at most voxels for nine.
    ThinningGrid near_idle_;
    PaddedDistance depth_;
    std::array<std::int32_t, 27> steps_;
    std::array<std::int32_t, 27> row_steps_{};
    std::vector<std::vector<VoxelIndex>> levels_;
    std::vector<Exposed> exposed_;  ///< in this wave
    std::size_t next_exposed_ = 0;  ///< the first that is in no level yet
};

}  // namespace

ThinningGrid peel(const voxel::BitVolume& solid, const voxel::DistanceField& distance,
                  const ThinningGrid& keep, const std::stop_token& stop) {
    return Peeling(solid, distance, keep).run(stop);
}

}  // namespace ossuary::skeleton
