#include "index/missing_features.h"

#include <vector>

#include "engine/core/parallel.h"
#include "engine/registration/piece_search.h"
#include "index/preview.h"

namespace ossuary::index {

namespace {

constexpr std::size_t kAtOnce = 64;

}  // namespace

Result<std::size_t> add_missing_features(Store& store, int jobs, ProgressSink& sink,
                                         const std::stop_token& stop) {
    std::size_t made = 0;
    ModelId after = 0;
    while (true) {
        if (stop.stop_requested()) {
            return {ErrorCode::kCancelled, "features of surfaces: stopped; what is done is kept"};
        }
        const auto models = store.without_features(after, kAtOnce);
        if (!models) return models.error();
        if (models->empty()) return made;
        if (made == 0) sink.phase("making features of surfaces that the index lacks");
        after = models->back().id;
        std::vector<mesh::TriangleMesh> meshes(models->size());
        for (std::size_t i = 0; i < models->size(); ++i) {
            const auto preview = store.preview((*models)[i].id);
            // One that is damaged is told by verify.
            if (preview) meshes[i] = mesh_of(*preview);
        }
        std::vector<AddFeatures> added(models->size());
        parallel_for(models->size(), jobs, [&](std::size_t i) {
            if (stop.stop_requested() || meshes[i].triangles.empty()) return;
            added[i] = {(*models)[i].id, (*models)[i].changed_at,
                        registration::whole_features(meshes[i])};
        });
        std::vector<Change> changes;
        for (AddFeatures& each : added) {
            if (!each.features.features.points.empty()) changes.emplace_back(std::move(each));
        }
        if (changes.empty()) continue;
        if (const auto written = store.apply(changes); !written) return written.error();
        made += changes.size();
    }
}

}  // namespace ossuary::index
