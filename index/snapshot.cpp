#include "index/snapshot.h"

#include <algorithm>
#include <unordered_map>

namespace ossuary::index {

namespace {

/// The blocks of before with those that have changed in their places.
std::vector<StoredScan::Block> merged(const std::vector<StoredScan::Block>& before,
                                      std::vector<StoredScan::Block> changed) {
    std::vector<StoredScan::Block> blocks;
    blocks.reserve(before.size() + changed.size());
    auto old = before.begin();
    for (StoredScan::Block& block : changed) {
        for (; old != before.end() && old->number < block.number; ++old) blocks.push_back(*old);
        if (old != before.end() && old->number == block.number) ++old;
        blocks.push_back(std::move(block));
    }
    blocks.insert(blocks.end(), old, before.end());
    return blocks;
}

}  // namespace

Result<std::shared_ptr<const Snapshot>> Snapshot::load(Store& store, const Snapshot* previous) {
    auto scan = store.scan(previous != nullptr ? std::optional(previous->state_) : std::nullopt);
    if (!scan) return scan.error();
    std::shared_ptr<Snapshot> snapshot(new Snapshot());
    snapshot->assemble(*std::move(scan), previous);
    return std::shared_ptr<const Snapshot>(std::move(snapshot));
}

void Snapshot::assemble(StoredScan scan, const Snapshot* previous) {
    if (scan.whole) previous = nullptr;
    state_ = scan.state;
    blocks_ = previous != nullptr ? merged(previous->blocks_, std::move(scan.blocks))
                                  : std::move(scan.blocks);
    first_.push_back(0);
    std::vector<const ranking::ScanRows*> rows;
    for (const StoredScan::Block& block : blocks_) {
        first_.push_back(first_.back() + block.models->size());
        rows.push_back(&block.models->rows);
    }
    preselection_ = ranking::Preselection(std::move(rows));
    if (scan.statistics) {
        judgement_ = std::make_shared<const Judgement>(std::move(scan.statistics->statistics));
    } else {
        judgement_ =
            previous != nullptr ? previous->judgement_ : std::make_shared<const Judgement>();
    }
    roots_ = ModelRoots(scan.outer_paths);
    catalogue_ = CatalogueBlocks(blocks_, previous != nullptr ? &previous->catalogue_ : nullptr);
    loops_ = LoopBlocks(blocks_, previous != nullptr ? &previous->loops_ : nullptr);
}

Snapshot::Place Snapshot::place(std::size_t position) const {
    assert(position < size());
    const auto after = std::upper_bound(first_.begin(), first_.end(), position);
    const auto block = static_cast<std::size_t>(after - first_.begin()) - 1;
    return {*blocks_[block].models, position - first_[block]};
}

ModelId Snapshot::id(std::size_t position) const {
    const Place found = place(position);
    return found.block.ids[found.at];
}

Revision Snapshot::changed_at(std::size_t position) const {
    const Place found = place(position);
    return found.block.changed_at[found.at];
}

std::string_view Snapshot::class_name(std::size_t position) const {
    const Place found = place(position);
    return found.block.class_name(found.at);
}

std::uint64_t Snapshot::measures(std::size_t position) const {
    const Place found = place(position);
    return found.block.measures[found.at];
}

std::optional<std::size_t> Snapshot::find(ModelId id) const {
    if (id < 0) return {};
    const std::int64_t number = id / kScanBlockModels;
    const auto block = std::lower_bound(
        blocks_.begin(), blocks_.end(), number,
        [](const StoredScan::Block& each, std::int64_t wanted) { return each.number < wanted; });
    if (block == blocks_.end() || block->number != number) return {};
    const std::vector<ModelId>& ids = block->models->ids;
    const auto at = std::lower_bound(ids.begin(), ids.end(), id);
    if (at == ids.end() || *at != id) return {};
    return first_[static_cast<std::size_t>(block - blocks_.begin())] +
           static_cast<std::size_t>(at - ids.begin());
}

std::vector<std::uint32_t> Snapshot::of_class(std::string_view class_name) const {
    std::vector<std::uint32_t> positions;
    for_each_block([&](const ScanBlock& block, std::size_t first) {
        const auto& names = block.class_names;
        const auto name = std::find(names.begin(), names.end(), class_name);
        if (name == names.end()) return;
        const auto number = static_cast<std::uint32_t>(name - names.begin());
        for (std::size_t i = 0; i < block.size(); ++i) {
            if (block.classes[i] != number) continue;
            positions.push_back(static_cast<std::uint32_t>(first + i));
        }
    });
    return positions;
}

std::vector<std::size_t> Snapshot::count_measures(const std::vector<std::uint64_t>& keys) const {
    std::unordered_map<std::uint64_t, std::size_t> counts;
    for (const std::uint64_t key : keys) counts.emplace(key, 0);
    for_each_block([&](const ScanBlock& block, std::size_t) {
        for (const std::uint64_t key : block.measures) {
            const auto found = counts.find(key);
            if (found != counts.end()) ++found->second;
        }
    });
    std::vector<std::size_t> result;
    result.reserve(keys.size());
    for (const std::uint64_t key : keys) result.push_back(counts[key]);
    return result;
}

}  // namespace ossuary::index
