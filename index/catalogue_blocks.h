#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "index/lazy_blocks.h"
#include "index/model.h"
#include "index/store.h"

namespace ossuary::index {

/// A model as lists, facets and classifications ask for it.
struct CatalogueEntry {
    ModelId id = 0;
    std::uint32_t faces = 0, branches = 0;
    std::string_view name, class_name, path, indexed_at;  ///< as in ModelSummary
    double longest_side = 0.0, metres_per_unit = 0.0;     ///< as in ListedModel
};

/// Some models' entries and the text that they point into.
class CatalogueBlock {
public:
    explicit CatalogueBlock(std::span<const ListedModel> models);
    [[nodiscard]] const std::vector<CatalogueEntry>& entries() const { return entries_; }

private:
    std::string text_;
    std::vector<CatalogueEntry> entries_;
};

/// All models of a snapshot, in the order of positions.
class Catalogue {
public:
    explicit Catalogue(std::vector<std::shared_ptr<const CatalogueBlock>> blocks);

    [[nodiscard]] std::size_t size() const { return entries_.size(); }
    [[nodiscard]] const CatalogueEntry& operator[](std::size_t position) const {
        return *entries_[position];
    }
    /// Positions by name, in natural order (catalogue.h); sorted at the first call.
    [[nodiscard]] const std::vector<std::size_t>& by_name() const;

private:
    std::vector<std::shared_ptr<const CatalogueBlock>> blocks_;
    std::vector<const CatalogueEntry*> entries_;
    mutable std::once_flag named_;
    mutable std::vector<std::size_t> by_name_;  ///< once `named_`
};

/// The catalogue of one snapshot, read when somebody asks for it.
class CatalogueBlocks {
public:
    CatalogueBlocks() = default;
    CatalogueBlocks(const std::vector<StoredScan::Block>& blocks, const CatalogueBlocks* previous)
        : blocks_(blocks, previous != nullptr ? &previous->blocks_ : nullptr) {}

    /// Errors: those of the store.
    Result<std::shared_ptr<const Catalogue>> load(Store& store) const;

private:
    LazyBlocks<CatalogueBlock, Catalogue> blocks_;
};

}  // namespace ossuary::index
