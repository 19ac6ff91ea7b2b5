#include "index/catalogue_blocks.h"

#include <algorithm>
#include <numeric>

#include "index/catalogue.h"

namespace ossuary::index {

namespace {

/// Entries as a block's scan has its models; one that the store does not have any more keeps its
/// place without a name.
std::vector<ListedModel> as_scanned(const ScanBlock& block, std::span<const ListedModel> listed) {
    std::vector<ListedModel> models;
    auto next = listed.begin();
    for (std::size_t i = 0; i < block.size(); ++i) {
        while (next != listed.end() && next->id < block.ids[i]) ++next;
        if (next != listed.end() && next->id == block.ids[i]) {
            models.push_back(*next);
        } else {
            models.emplace_back().id = block.ids[i];
        }
        models.back().class_name = block.class_name(i);
    }
    return models;
}

}  // namespace

CatalogueBlock::CatalogueBlock(std::span<const ListedModel> models) {
    for (const ListedModel& model : models) {
        for (const std::string* text :
             {&model.name, &model.class_name, &model.path, &model.indexed_at}) {
            text_ += *text;
        }
    }
    text_.shrink_to_fit();
    std::size_t at = 0;
    const auto next = [&](const std::string& text) {
        const std::string_view view = std::string_view(text_).substr(at, text.size());
        at += text.size();
        return view;
    };
    entries_.reserve(models.size());
    for (const ListedModel& model : models) {
        CatalogueEntry entry{model.id, model.faces,        model.branches,       {}, {}, {},
                             {},       model.longest_side, model.metres_per_unit};
        entry.name = next(model.name);
        entry.class_name = next(model.class_name);
        entry.path = next(model.path);
        entry.indexed_at = next(model.indexed_at);
        entries_.push_back(entry);
    }
}

Catalogue::Catalogue(std::vector<std::shared_ptr<const CatalogueBlock>> blocks)
    : blocks_(std::move(blocks)) {
    for (const auto& block : blocks_) {
        for (const CatalogueEntry& entry : block->entries()) entries_.push_back(&entry);
    }
}

const std::vector<std::size_t>& Catalogue::by_name() const {
    std::call_once(named_, [this] {
        by_name_.resize(size());
        std::iota(by_name_.begin(), by_name_.end(), std::size_t{0});
        std::stable_sort(by_name_.begin(), by_name_.end(), [this](std::size_t a, std::size_t b) {
            return natural_less((*this)[a].name, (*this)[b].name);
        });
    });
    return by_name_;
}

CatalogueBlocks::CatalogueBlocks(const std::vector<StoredScan::Block>& blocks,
                                 const CatalogueBlocks* previous) {
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
        blocks_.push_back({block.number, block.models, same ? old->entries : nullptr});
    }
}

CatalogueBlocks& CatalogueBlocks::operator=(CatalogueBlocks&& other) noexcept {
    const Lock theirs(other.mutex_);
    const Lock ours(mutex_);
    blocks_ = std::move(other.blocks_);
    whole_ = std::move(other.whole_);
    return *this;
}

Result<std::shared_ptr<const Catalogue>> CatalogueBlocks::load(Store& store) const {
    const Lock lock(mutex_);
    if (whole_) return whole_;
    // Blocks beside each other are read at once, but not so many that their models fill memory.
    constexpr std::size_t kAtOnce = 64;
    for (std::size_t begin = 0; begin < blocks_.size();) {
        if (blocks_[begin].entries) {
            ++begin;
            continue;
        }
        std::size_t end = begin + 1;
        while (end < blocks_.size() && end - begin < kAtOnce && !blocks_[end].entries) ++end;
        const auto listed = store.listed(blocks_[begin].number * kScanBlockModels,
                                         (blocks_[end - 1].number + 1) * kScanBlockModels - 1);
        if (!listed) return listed.error();
        for (; begin < end; ++begin) {
            Block& block = blocks_[begin];
            const auto from = [](const ListedModel& model, ModelId id) { return model.id < id; };
            const auto first = std::lower_bound(listed->begin(), listed->end(),
                                                block.number * kScanBlockModels, from);
            const auto last =
                std::lower_bound(first, listed->end(), (block.number + 1) * kScanBlockModels, from);
            block.entries = std::make_shared<const CatalogueBlock>(
                as_scanned(*block.models, std::span(first, last)));
        }
    }
    std::vector<std::shared_ptr<const CatalogueBlock>> entries;
    for (const Block& block : blocks_) entries.push_back(block.entries);
    whole_ = std::make_shared<const Catalogue>(std::move(entries));
    return whole_;
}

}  // namespace ossuary::index
