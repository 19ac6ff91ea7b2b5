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

namespace {

/// Blocks beside each other are read at once, but not so many that their models fill memory.
Result<void> read_entries(Store& store, std::vector<LazyBlock<CatalogueBlock>>& blocks) {
    constexpr std::size_t kAtOnce = 64;
    for (std::size_t begin = 0; begin < blocks.size();) {
        if (blocks[begin].value) {
            ++begin;
            continue;
        }
        std::size_t end = begin + 1;
        while (end < blocks.size() && end - begin < kAtOnce && !blocks[end].value) ++end;
        const auto listed = store.listed(blocks[begin].number * kScanBlockModels,
                                         (blocks[end - 1].number + 1) * kScanBlockModels - 1);
        if (!listed) return listed.error();
        for (; begin < end; ++begin) {
            LazyBlock<CatalogueBlock>& block = blocks[begin];
            const auto from = [](const ListedModel& model, ModelId id) { return model.id < id; };
            const auto first = std::lower_bound(listed->begin(), listed->end(),
                                                block.number * kScanBlockModels, from);
            const auto last =
                std::lower_bound(first, listed->end(), (block.number + 1) * kScanBlockModels, from);
            block.value = std::make_shared<const CatalogueBlock>(
                as_scanned(*block.models, std::span(first, last)));
        }
    }
    return {};
}

}  // namespace

Result<std::shared_ptr<const Catalogue>> CatalogueBlocks::load(Store& store) const {
    const auto join = [](const std::vector<LazyBlock<CatalogueBlock>>& blocks) {
        std::vector<std::shared_ptr<const CatalogueBlock>> entries;
        for (const auto& block : blocks) entries.push_back(block.value);
        return std::make_shared<const Catalogue>(std::move(entries));
    };
    return blocks_.load([&](auto& blocks) { return read_entries(store, blocks); }, join);
}

}  // namespace ossuary::index
