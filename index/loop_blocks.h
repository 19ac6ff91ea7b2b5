#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/core/result.h"
#include "index/lazy_blocks.h"
#include "index/store.h"

namespace ossuary::index {

/// How many loops the skeletons of one snapshot have, read when somebody asks for it. Apart from
/// the catalogue, which is there ten times as soon.
class LoopBlocks {
public:
    using Counts = std::vector<std::uint32_t>;

    LoopBlocks() = default;
    LoopBlocks(const std::vector<StoredScan::Block>& blocks, const LoopBlocks* previous)
        : blocks_(blocks, previous != nullptr ? &previous->blocks_ : nullptr) {}

    /// In the order of positions. Errors: those of the store.
    Result<std::shared_ptr<const Counts>> load(Store& store) const;

private:
    LazyBlocks<Counts, Counts> blocks_;
};

}  // namespace ossuary::index
