#pragma once

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstdint>
#include <vector>

#include "engine/skeleton/thinning_grid.h"

namespace ossuary::skeleton {

/// A monotone queue of voxels by level (a small integer that never falls below the one being
/// served): a ring of lists with a bitmap of those that are not empty. Used by shortest paths with
/// level = cost / smallest step, where every voxel is final once its level is served (Denardo &
/// Fox, "Shortest-route methods", 1979). Levels that rounding has put outside the ring are moved to
/// its nearer end.
class BucketQueue {
public:
    /// @param span  levels pushed are below the level being served plus `span`
    explicit BucketQueue(std::size_t span)
        : heads_(std::bit_ceil(std::max<std::size_t>(span + 1, 64)), kNone),
          filled_(heads_.size() / 64, 0) {}

    [[nodiscard]] bool empty() const { return size_ == 0; }

    /// Starts again with an empty queue at a level.
    void restart(std::uint64_t level) {
        assert(empty());
        level_ = level;
        entries_.clear();
        free_ = kNone;
    }

    /// A level of a real number. (To an unsigned integer it would take a branch.)
    static std::uint64_t level_of(float value) {
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(value));
    }

    void push(std::uint64_t level, VoxelIndex voxel) {
        level = std::clamp(level, level_, level_ + heads_.size() - 1);
        const std::size_t slot = static_cast<std::size_t>(level) & (heads_.size() - 1);
        std::uint32_t entry = free_;
        if (entry == kNone) {
            entry = static_cast<std::uint32_t>(entries_.size());
            entries_.push_back({});
        } else {
            free_ = entries_[entry].next;
        }
        entries_[entry] = {voxel, heads_[slot]};
        heads_[slot] = entry;
        filled_[slot >> 6] |= std::uint64_t{1} << (slot & 63);
        ++size_;
    }

    /// Takes a voxel of the lowest level. @pre not empty
    VoxelIndex pop() {
        assert(!empty());
        const std::size_t slot = advance();
        const std::uint32_t entry = heads_[slot];
        const VoxelIndex voxel = entries_[entry].voxel;
        heads_[slot] = entries_[entry].next;
        if (heads_[slot] == kNone) filled_[slot >> 6] &= ~(std::uint64_t{1} << (slot & 63));
        entries_[entry].next = free_;
        free_ = entry;
        --size_;
        return voxel;
    }

private:
    static constexpr std::uint32_t kNone = 0xffffffffu;
    struct Entry {
        VoxelIndex voxel = 0;
        std::uint32_t next = kNone;
    };

    /// Moves `level_` to the lowest filled level and returns its slot.
    std::size_t advance() {
        std::size_t slot = static_cast<std::size_t>(level_) & (heads_.size() - 1);
        std::uint64_t word = filled_[slot >> 6] >> (slot & 63);
        if (word == 0) {
            std::size_t skipped = 64 - (slot & 63);
            std::size_t w = (slot >> 6) + 1;
            while ((word = filled_[w & (filled_.size() - 1)]) == 0) {
                ++w;
                skipped += 64;
            }
            level_ += skipped;
        }
        level_ += static_cast<std::uint64_t>(std::countr_zero(word));
        return static_cast<std::size_t>(level_) & (heads_.size() - 1);
    }

    std::vector<std::uint32_t> heads_;
    std::vector<std::uint64_t> filled_;
    std::vector<Entry> entries_;
    std::uint32_t free_ = kNone;
    std::uint64_t level_ = 0;
    std::size_t size_ = 0;
};

}  // namespace ossuary::skeleton
