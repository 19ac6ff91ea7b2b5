#include "index/snapshot.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

#include "index/catalogue.h"

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
    snapshot->roots_ = ModelRoots(snapshot->models_);
    snapshot->number_copies();
    return std::shared_ptr<const Snapshot>(std::move(snapshot));
}

const std::vector<std::size_t>& Snapshot::by_name() const {
    std::call_once(named_, [this] {
        by_name_.resize(models_.size());
        std::iota(by_name_.begin(), by_name_.end(), std::size_t{0});
        std::stable_sort(by_name_.begin(), by_name_.end(), [this](std::size_t a, std::size_t b) {
            return natural_less(models_[a].name, models_[b].name);
        });
    });
    return by_name_;
}

void Snapshot::number_copies() {
    // The bytes of a file say less: the same mesh may be saved under another header.
    const auto measures = [](const ModelSummary& model) {
        const Vec3& low = model.bounds.min();
        const Vec3& high = model.bounds.max();
        return std::tuple(model.vertices, model.faces, model.surface_area, low.x(), low.y(),
                          low.z(), high.x(), high.y(), high.z());
    };
    std::map<decltype(measures(ModelSummary{})), std::size_t> numbers;
    for (const ModelSummary& model : models_) {
        const auto number = numbers.try_emplace(measures(model), numbers.size()).first->second;
        if (number == copy_counts_.size()) copy_counts_.push_back(0);
        ++copy_counts_[number];
        copies_.push_back(number);
    }
}

std::optional<std::size_t> Snapshot::find(ModelId id) const {
    const auto found = std::lower_bound(
        models_.begin(), models_.end(), id,
        [](const ModelSummary& model, ModelId wanted) { return model.id < wanted; });
    if (found == models_.end() || found->id != id) return {};
    return static_cast<std::size_t>(found - models_.begin());
}

}  // namespace ossuary::index
