#pragma once

#include <algorithm>
#include <cstdint>
#include <stop_token>

#include "engine/core/geometry.h"

namespace ossuary::voxel {

/// What finding the inside of one mesh has cost and may cost. Where it runs out the surface passes
/// through each voxel again and again, from all sides (a soup of a million large triangles): lines
/// then tell nothing any more, and their crossings would fill memory. What is counted follows from
/// the mesh alone, so that the outcome is the same on every machine and for every order of the
/// triangles.
class CastMeter {
public:
    /// @param box  voxels along the sides of the mesh's bounding box
    /// @param stop  looked at every few 100 µs; must outlive the meter
    CastMeter(const Vec3i& box, const std::stop_token& stop)
        : stop_(stop), most_crossings_(crossings_for(box)), most_work_(work_for(box)) {}

    /// Begins with the parts that lines in thirteen directions vote on: they may cost less, since
    /// where votes are dear they are also worth little.
    void begin_voting() { most_work_ = std::min(most_work_, work_ + most_work_ / 4); }
    /// Begins with the lines of one direction.
    void begin_cast() { crossings_ = 0; }

    /// Counts rows of lines looked at and crossings found. Returns whether to go on.
    bool count(std::uint64_t rows, std::uint64_t crossings) {
        crossings_ += crossings;
        too_many_ = too_many_ || crossings_ > most_crossings_;
        return count_steps(rows + kCrossing * crossings) && !too_many_;
    }
    /// Counts short steps of other kinds, a few nanoseconds each.
    bool count_steps(std::uint64_t steps) {
        work_ += steps;
        return work_ < next_look_ || look();
    }

    /// Whether to give up: what was found is then not complete.
    [[nodiscard]] bool over() const { return stopped_ || too_many_ || work_ > most_work_; }
    [[nodiscard]] bool stopped() const { return stopped_ || stop_.stop_requested(); }
    [[nodiscard]] std::uint64_t work() const { return work_; }

private:
    static constexpr std::uint64_t kCrossing = 4;  ///< found, kept, sorted and read again
    static constexpr std::uint64_t kBetweenLooks = 1 << 16;

    /// In one direction: two for each voxel. Of the models of the two benchmarks none has more than
    /// a tenth (docs/performance.md, worst cases).
    static std::uint64_t crossings_for(const Vec3i& box) {
        const auto voxels = static_cast<std::uint64_t>(box.x()) *
                            static_cast<std::uint64_t>(box.y()) *
                            static_cast<std::uint64_t>(box.z());
        return std::clamp<std::uint64_t>(2 * voxels, 1 << 20, 1 << 24);
    }
    /// Half a second to a second, and more where more is asked for.
    static std::uint64_t work_for(const Vec3i& box) {
        const auto longest = static_cast<std::uint64_t>(box.maxCoeff());
        return (std::uint64_t{1} << 28) + 512 * longest * longest;
    }

    bool look() {
        next_look_ = work_ + kBetweenLooks;
        stopped_ = stopped_ || stop_.stop_requested();
        return !over();
    }

    const std::stop_token& stop_;
    std::uint64_t most_crossings_, most_work_;
    std::uint64_t crossings_ = 0, work_ = 0, next_look_ = kBetweenLooks;
    bool too_many_ = false, stopped_ = false;
};

}  // namespace ossuary::voxel
