#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/core/mutex.h"
#include "engine/core/result.h"
#include "index/store.h"

namespace ossuary::index {

/// How many loops the skeletons of one snapshot have, read when somebody asks for it; blocks that
/// an earlier snapshot has are not read again. Apart from the catalogue, which is there ten times
/// as soon.
class LoopBlocks {
public:
    LoopBlocks() = default;
    explicit LoopBlocks(const std::vector<StoredScan::Block>& blocks, const LoopBlocks* previous);
    LoopBlocks(const LoopBlocks&) = delete;
    LoopBlocks& operator=(LoopBlocks&&) noexcept;
    ~LoopBlocks() = default;

    /// In the order of positions. Errors: those of the store.
    Result<std::shared_ptr<const std::vector<std::uint32_t>>> load(Store& store) const;

private:
    struct Block {
        std::int64_t number = 0;
        std::shared_ptr<const ScanBlock> models;
        std::shared_ptr<const std::vector<std::uint32_t>> loops;  ///< null until read
    };
    mutable Mutex mutex_;
    mutable std::vector<Block> blocks_ OSSUARY_GUARDED_BY(mutex_);
    mutable std::shared_ptr<const std::vector<std::uint32_t>> whole_ OSSUARY_GUARDED_BY(mutex_);
};

}  // namespace ossuary::index
