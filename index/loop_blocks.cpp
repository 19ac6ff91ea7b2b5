#include "index/loop_blocks.h"

#include <algorithm>
#include <utility>

namespace ossuary::index {

LoopBlocks::LoopBlocks(const std::vector<StoredScan::Block>& blocks, const LoopBlocks* previous) {
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
        blocks_.push_back({block.number, block.models, same ? old->loops : nullptr});
    }
}

LoopBlocks& LoopBlocks::operator=(LoopBlocks&& other) noexcept {
    const Lock theirs(other.mutex_);
    const Lock ours(mutex_);
    blocks_ = std::move(other.blocks_);
    whole_ = std::move(other.whole_);
    return *this;
}

Result<std::shared_ptr<const std::vector<std::uint32_t>>> LoopBlocks::load(Store& store) const {
    const Lock lock(mutex_);
    if (whole_) return whole_;
    std::vector<std::uint32_t> all;
    for (Block& block : blocks_) {
        if (!block.loops) {
            const ModelId first = block.number * kScanBlockModels;
            const auto found = store.loops(first, first + kScanBlockModels - 1);
            if (!found) return found.error();
            std::vector<std::uint32_t> loops;
            auto next = found->begin();
            for (const ModelId id : block.models->ids) {
                while (next != found->end() && next->id < id) ++next;
                const bool there = next != found->end() && next->id == id;
                loops.push_back(there ? next->loops : 0);
            }
            block.loops = std::make_shared<const std::vector<std::uint32_t>>(std::move(loops));
        }
        all.insert(all.end(), block.loops->begin(), block.loops->end());
    }
    whole_ = std::make_shared<const std::vector<std::uint32_t>>(std::move(all));
    return whole_;
}

}  // namespace ossuary::index
