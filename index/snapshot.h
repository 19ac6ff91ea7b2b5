#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "engine/core/result.h"
#include "engine/descriptor/model_descriptor.h"
#include "engine/ranking/preselection.h"
#include "engine/ranking/ranker.h"
#include "index/model.h"
#include "index/model_roots.h"
#include "index/store.h"

namespace ossuary::index {

/// An index's models at one revision, in memory and immutable, so that any number of threads may
/// search it while the index grows. A later snapshot shares the descriptors of unchanged models.
class Snapshot {
public:
    /// Reads the store's current revision; with `previous`, only what has changed since.
    static Result<std::shared_ptr<const Snapshot>> load(Store& store,
                                                        const Snapshot* previous = nullptr);

    [[nodiscard]] Revision revision() const { return state_.models; }
    [[nodiscard]] const CollectionState& state() const { return state_; }
    [[nodiscard]] std::size_t size() const { return models_.size(); }
    /// In the order of their ids.
    [[nodiscard]] const std::vector<ModelSummary>& models() const { return models_; }
    /// As long as `models()`, in the same order.
    [[nodiscard]] ranking::DescriptorSpan descriptors() const { return descriptor_pointers_; }
    /// Of `descriptors()`.
    [[nodiscard]] const ranking::Preselection& preselection() const { return preselection_; }
    /// Empty in an index that has none yet; perhaps of an earlier revision, see `state`.
    [[nodiscard]] const ranking::CollectionStatistics& statistics() const { return statistics_; }
    /// Where the models lie.
    [[nodiscard]] const ModelRoots& roots() const { return roots_; }
    /// A number that models have in common whose meshes measure the same to the last bit, wherever
    /// their files lie: copies of each other.
    [[nodiscard]] std::size_t copies(std::size_t position) const { return copies_[position]; }
    /// How many models have that number; models() has so many more than there are numbers.
    [[nodiscard]] std::size_t copy_count(std::size_t number) const { return copy_counts_[number]; }
    [[nodiscard]] std::size_t redundant() const { return models_.size() - copy_counts_.size(); }
    /// Positions in models() by name, in natural order (catalogue.h); sorted at the first call.
    [[nodiscard]] const std::vector<std::size_t>& by_name() const;
    /// Position of a model in `models()`; none when it is not there.
    [[nodiscard]] std::optional<std::size_t> find(ModelId id) const;

private:
    Snapshot() = default;
    void number_copies();

    CollectionState state_;
    std::vector<ModelSummary> models_;
    std::vector<KnownModel> known_;
    std::vector<std::shared_ptr<const descriptor::ModelDescriptor>> descriptors_;
    std::vector<const descriptor::ModelDescriptor*> descriptor_pointers_;
    ranking::Preselection preselection_;
    ranking::CollectionStatistics statistics_;
    ModelRoots roots_;
    std::vector<std::size_t> copies_;       ///< a number for each model
    std::vector<std::size_t> copy_counts_;  ///< a count for each number
    mutable std::once_flag named_;
    mutable std::vector<std::size_t> by_name_;  ///< once `named_`
};

}  // namespace ossuary::index
