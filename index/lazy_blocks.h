#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "engine/core/mutex.h"
#include "engine/core/result.h"
#include "index/store.h"

namespace ossuary::index {

/// One block of a snapshot's models and what is known of it: null until read.
template <typename Value>
struct LazyBlock {
    std::int64_t number = 0;
    std::shared_ptr<const ScanBlock> models;
    std::shared_ptr<const Value> value;
};

/// What is read of a snapshot's models when somebody asks for it, by blocks; those that an earlier
/// snapshot has are not read again. Safe to use from several threads.
/// @tparam Whole  what is made of all values, in the order of blocks
template <typename Value, typename Whole>
class LazyBlocks {
public:
    using Block = LazyBlock<Value>;

    LazyBlocks() = default;
    LazyBlocks(const std::vector<StoredScan::Block>& blocks, const LazyBlocks* previous) {
        std::vector<Block> known;
        if (previous != nullptr) {
            const Lock lock(previous->mutex_);
            known = previous->blocks_;
        }
        const Lock lock(mutex_);
        auto old = known.begin();
        for (const StoredScan::Block& block : blocks) {
            while (old != known.end() && old->number < block.number) ++old;
            const bool same = old != known.end() && old->models == block.models;
            blocks_.push_back({block.number, block.models, same ? old->value : nullptr});
        }
    }
    LazyBlocks(const LazyBlocks&) = delete;
    LazyBlocks& operator=(LazyBlocks&& other) noexcept {
        const Lock theirs(other.mutex_);
        const Lock ours(mutex_);
        blocks_ = std::move(other.blocks_);
        whole_ = std::move(other.whole_);
        return *this;
    }
    ~LazyBlocks() = default;

    /// @param read  fills the values that are null: Result<void>(std::vector<Block>&)
    /// @param join  makes the whole: std::shared_ptr<const Whole>(const std::vector<Block>&)
    template <typename Read, typename Join>
    Result<std::shared_ptr<const Whole>> load(const Read& read, const Join& join) const {
        const Lock lock(mutex_);
        if (whole_) return whole_;
        if (const auto done = read(blocks_); !done) return done.error();
        whole_ = join(std::as_const(blocks_));
        return whole_;
    }

private:
    mutable Mutex mutex_;
    mutable std::vector<Block> blocks_ OSSUARY_GUARDED_BY(mutex_);
    mutable std::shared_ptr<const Whole> whole_ OSSUARY_GUARDED_BY(mutex_);
};

}  // namespace ossuary::index
