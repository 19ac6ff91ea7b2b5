#include "index/loop_blocks.h"

#include <utility>

namespace ossuary::index {

namespace {

using Block = LazyBlock<LoopBlocks::Counts>;

Result<void> read_loops(Store& store, std::vector<Block>& blocks) {
    for (Block& block : blocks) {
        if (block.value) continue;
        const ModelId first = block.number * kScanBlockModels;
        const auto found = store.loops(first, first + kScanBlockModels - 1);
        if (!found) return found.error();
        LoopBlocks::Counts loops;
        auto next = found->begin();
        for (const ModelId id : block.models->ids) {
            while (next != found->end() && next->id < id) ++next;
            const bool there = next != found->end() && next->id == id;
            loops.push_back(there ? next->loops : 0);
        }
        block.value = std::make_shared<const LoopBlocks::Counts>(std::move(loops));
    }
    return {};
}

}  // namespace

Result<std::shared_ptr<const LoopBlocks::Counts>> LoopBlocks::load(Store& store) const {
    const auto join = [](const std::vector<Block>& blocks) {
        auto all = std::make_shared<Counts>();
        for (const Block& block : blocks) {
            all->insert(all->end(), block.value->begin(), block.value->end());
        }
        return all;
    };
    return blocks_.load([&](auto& blocks) { return read_loops(store, blocks); }, join);
}

}  // namespace ossuary::index
