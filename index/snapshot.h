#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/ranking/normalization.h"
#include "engine/ranking/preselection.h"
#include "engine/ranking/ranker.h"
#include "index/catalogue_blocks.h"
#include "index/loop_blocks.h"
#include "index/model.h"
#include "index/model_roots.h"
#include "index/scan_block.h"
#include "index/store.h"

namespace ossuary::index {

/// What searches look at of an index's models at one revision, in memory and immutable, so that any
/// number of threads may search it while the index grows: about a kilobyte and a half a model. A
/// later snapshot shares the blocks of models that have not changed. Everything else of a model is
/// asked of the store, which may know a later revision (`changed_at` tells).
class Snapshot {
public:
    /// Reads the store's current revision; with `previous`, only what has changed since.
    static Result<std::shared_ptr<const Snapshot>> load(Store& store,
                                                        const Snapshot* previous = nullptr);

    [[nodiscard]] Revision revision() const { return state_.models; }
    [[nodiscard]] const CollectionState& state() const { return state_; }
    [[nodiscard]] std::size_t size() const { return preselection_.size(); }

    // Of the model at a position, from 0 to size(); positions are in the order of ids.

    [[nodiscard]] ModelId id(std::size_t position) const;
    /// The revision at which the model last changed.
    [[nodiscard]] Revision changed_at(std::size_t position) const;
    [[nodiscard]] std::string_view class_name(std::size_t position) const;
    /// A number that models have in common whose meshes measure the same to the last bit: copies of
    /// each other (measures_key).
    [[nodiscard]] std::uint64_t measures(std::size_t position) const;
    /// Position of a model; none when it is not there.
    [[nodiscard]] std::optional<std::size_t> find(ModelId id) const;
    /// Of the models of a class ("" = of none), ascending.
    [[nodiscard]] std::vector<std::uint32_t> of_class(std::string_view class_name) const;
    /// For each of `keys` the number of models that have it as their `measures`.
    [[nodiscard]] std::vector<std::size_t> count_measures(
        const std::vector<std::uint64_t>& keys) const;

    [[nodiscard]] const ranking::Preselection& preselection() const { return preselection_; }
    /// Empty in an index that has none yet; perhaps of an earlier revision, see `state`.
    [[nodiscard]] const ranking::CollectionStatistics& statistics() const {
        return judgement_->statistics;
    }
    /// Of `statistics`.
    [[nodiscard]] const ranking::Normalization& normalization() const {
        return judgement_->normalization;
    }
    /// Where the models lie.
    [[nodiscard]] const ModelRoots& roots() const { return roots_; }
    /// The names and paths of all models, read from the store where they are not known yet.
    Result<std::shared_ptr<const Catalogue>> catalogue(Store& store) const {
        return catalogue_.load(store);
    }
    /// How many loops the skeletons of all models have, likewise.
    Result<std::shared_ptr<const std::vector<std::uint32_t>>> loops(Store& store) const {
        return loops_.load(store);
    }

    /// Calls visit(block, position of its first model) for each block.
    template <typename Visit>
    void for_each_block(const Visit& visit) const {
        for (std::size_t i = 0; i < blocks_.size(); ++i) visit(*blocks_[i].models, first_[i]);
    }

private:
    /// What models are judged by.
    struct Judgement {
        explicit Judgement(ranking::CollectionStatistics made = {})
            : statistics(std::move(made)), normalization(statistics) {}
        ranking::CollectionStatistics statistics;
        ranking::Normalization normalization;
    };
    struct Place {
        const ScanBlock& block;
        std::size_t at;
    };

    Snapshot() = default;
    /// Takes over what a scan has, and from `previous` what has not changed.
    void assemble(StoredScan scan, const Snapshot* previous);
    [[nodiscard]] Place place(std::size_t position) const;

    CollectionState state_;
    std::vector<StoredScan::Block> blocks_;
    std::vector<std::size_t> first_;  ///< position of each block's first model, and one more
    ranking::Preselection preselection_;
    std::shared_ptr<const Judgement> judgement_;
    ModelRoots roots_;
    CatalogueBlocks catalogue_;
    LoopBlocks loops_;
};

}  // namespace ossuary::index
