#include "index/snapshot.h"

#include <algorithm>

namespace ossuary::index {

Result<std::shared_ptr<const Snapshot>> Snapshot::load(Store& store, const Snapshot* previous) {
    auto contents = previous != nullptr
                        ? store.contents(previous->known_, previous->state_.replacements)
                        : store.contents();
    if (!contents) return contents.error();
    std::shared_ptr<Snapshot> snapshot(new Snapshot());
    snapshot->state_ = contents->state;
    snapshot->models_.reserve(contents->models.size());
    for (StoreContents::Model& model : contents->models) {
        if (model.summary) {
            snapshot->models_.push_back(*std::move(model.summary));
            snapshot->descriptors_.push_back(
                std::make_shared<const descriptor::ModelDescriptor>(*std::move(model.descriptor)));
        } else {
            const auto position = previous->find(model.id);
            assert(position.has_value());
            snapshot->models_.push_back(previous->models_[*position]);
            snapshot->descriptors_.push_back(previous->descriptors_[*position]);
        }
        snapshot->known_.push_back({model.id, model.changed_at});
        snapshot->descriptor_pointers_.push_back(snapshot->descriptors_.back().get());
    }
    snapshot->preselection_ = ranking::Preselection(snapshot->descriptors());
    if (contents->statistics) snapshot->statistics_ = std::move(contents->statistics->statistics);
    return std::shared_ptr<const Snapshot>(std::move(snapshot));
}

std::optional<std::size_t> Snapshot::find(ModelId id) const {
    const auto found = std::lower_bound(
        models_.begin(), models_.end(), id,
        [](const ModelSummary& model, ModelId wanted) { return model.id < wanted; });
    if (found == models_.end() || found->id != id) return {};
    return static_cast<std::size_t>(found - models_.begin());
}

}  // namespace ossuary::index
