#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <list>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "engine/core/mutex.h"
#include "engine/core/result.h"
#include "engine/ranking/descriptor_source.h"
#include "index/snapshot.h"
#include "index/store_pool.h"

namespace ossuary::index {

/// The descriptors that were asked for last, so that a search reads few of its finalists. Safe to
/// use from several threads.
class DescriptorCache {
public:
    struct Key {
        std::uint64_t replacements = 0;
        ModelId id = 0;
        Revision changed_at = 0;
        bool operator<(const Key& other) const {
            return std::tie(replacements, id, changed_at) <
                   std::tie(other.replacements, other.id, other.changed_at);
        }
    };
    /// Two thousand models, as many as are measured exhaustively, stay in any case.
    explicit DescriptorCache(std::size_t bytes = std::size_t{48} << 20) : bytes_limit_(bytes) {}

    /// Those of the keys that are there, in their order; null for the others.
    std::vector<ranking::SharedDescriptor> find(const std::vector<Key>& keys);
    void keep(const Key& key, ranking::SharedDescriptor descriptor);

private:
    struct Entry {
        Key key;
        ranking::SharedDescriptor descriptor;
        std::size_t bytes = 0;
    };
    const std::size_t bytes_limit_;
    Mutex mutex_;
    std::list<Entry> entries_ OSSUARY_GUARDED_BY(mutex_);  ///< the last used first
    std::map<Key, std::list<Entry>::iterator> places_ OSSUARY_GUARDED_BY(mutex_);
    std::size_t bytes_ OSSUARY_GUARDED_BY(mutex_) = 0;
};

/// A snapshot's descriptors, from the cache where they are in it, else from the store. A model that
/// has been changed or removed since the snapshot is not there any more.
class SnapshotDescriptors : public ranking::DescriptorSource {
public:
    /// @param cache  null: nothing is kept, as for a pass over a whole collection
    /// @param jobs   threads that decode
    SnapshotDescriptors(const Snapshot& snapshot, StorePool& stores, DescriptorCache* cache,
                        int jobs = 1)
        : snapshot_(snapshot), stores_(stores), cache_(cache), jobs_(jobs) {}

    [[nodiscard]] std::size_t size() const override { return snapshot_.size(); }
    Result<std::vector<ranking::SharedDescriptor>> fetch(
        std::span<const std::uint32_t> positions) override;

    /// Whether some model was asked for that was not there any more.
    [[nodiscard]] bool missed() const { return missed_; }

private:
    const Snapshot& snapshot_;
    StorePool& stores_;
    DescriptorCache* cache_;
    int jobs_;
    std::atomic<bool> missed_ = false;
};

}  // namespace ossuary::index
