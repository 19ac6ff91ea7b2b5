#include "index/part_search.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <string>
#include <utility>

#include "engine/core/parallel.h"
#include "index/preview.h"

namespace ossuary::index {

namespace {

constexpr std::size_t kPage = 256;      ///< models whose features are in memory at once
constexpr double kElsewhere = 0.5;      ///< share of the distance of what was not settled
constexpr double kSkeletonShare = 0.2;  ///< beside features, of what is not in its place
constexpr std::size_t kPlacedAtOnce = 16;

Error part_cancelled() { return {ErrorCode::kCancelled, "the search was cancelled"}; }

/// The features of all models of which there are any.
struct Likeness {
    std::vector<std::uint32_t> positions;  ///< ascending
    std::vector<double> values;            ///< piece_likeness of each of these
    bool complete = true;
};

Result<Likeness> likeness_of(const Question& question, Store& store) {
    const ranking::RankOptions& options = question.options.rank;
    Likeness likeness;
    std::vector<std::vector<std::uint16_t>> nearest;
    ModelId after = 0;
    while (true) {
        if (options.stop.stop_requested()) return part_cancelled();
        const auto page = store.features(after, kPage, options.jobs);
        if (!page) return page.error();
        if (page->empty()) break;
        after = page->back().id;
        std::vector<const registration::WholeFeatures*> known;
        for (const StoredFeatures& each : *page) {
            const auto position = question.snapshot.find(each.id);
            // Models of a later revision are seen by the next search.
            if (!position || question.snapshot.changed_at(*position) != each.changed_at) {
                likeness.complete = false;
                continue;
            }
            likeness.positions.push_back(static_cast<std::uint32_t>(*position));
            known.push_back(&each.features);
        }
        const std::size_t first = nearest.size();
        nearest.resize(first + known.size());
        parallel_for(known.size(), options.jobs, [&](std::size_t i) {
            nearest[first + i] = registration::nearest_features(*question.piece, *known[i]);
        });
    }
    likeness.values = registration::piece_likeness(nearest);
    return likeness;
}

/// Matches skeletons of the models at `positions`, ascending.
Result<void> match_skeletons(const Question& question, const std::vector<std::uint32_t>& positions,
                             std::vector<PartFit>& fits) {
    if (positions.empty()) return {};
    const Snapshot& snapshot = question.snapshot;
    ranking::NearestOptions nearest;
    nearest.count = snapshot.size();
    nearest.among = positions;
    const auto models =
        ranking::nearest_models(question.query, question.descriptors, snapshot.preselection(),
                                snapshot.normalization(), question.options.rank, nearest);
    if (!models) return models.error();
    for (const ranking::RankedModel& model : *models) fits[model.index].skeleton = model.distance;
    return {};
}

/// Lays the piece into the models at `positions`.
Result<void> place(const Question& question, Store& store,
                   const std::vector<std::uint32_t>& positions, std::vector<PartFit>& fits) {
    const ranking::RankOptions& options = question.options.rank;
    for (std::size_t begin = 0; begin < positions.size(); begin += kPlacedAtOnce) {
        const std::size_t count = std::min(kPlacedAtOnce, positions.size() - begin);
        std::vector<registration::WholeFeatures> features(count);
        std::vector<mesh::TriangleMesh> meshes(count);
        for (std::size_t i = 0; i < count; ++i) {
            const ModelId id = question.snapshot.id(positions[begin + i]);
            auto page = store.features(id - 1, 1);
            if (!page) return page.error();
            const auto preview = store.preview(id);
            if (!preview && preview.error().code != ErrorCode::kModelNotFound) {
                return preview.error();
            }
            // A model may have gone since the snapshot was made.
            if (!preview || page->empty() || page->front().id != id) continue;
            features[i] = std::move(page->front().features);
            meshes[i] = mesh_of(*preview);
        }
        parallel_for(count, options.jobs, [&](std::size_t i) {
            if (options.stop.stop_requested() || meshes[i].triangles.empty()) return;
            fits[positions[begin + i]].placement = registration::place_piece(
                *question.piece, features[i], registration::WholeSurface(meshes[i]));
        });
        if (options.stop.stop_requested()) return part_cancelled();
    }
    return {};
}

/// Settles the best places.
Result<void> settle(const Question& question, Store& store, std::vector<std::uint32_t> positions,
                    std::size_t count, std::vector<PartFit>& fits) {
    std::erase_if(positions, [&](std::uint32_t at) { return !fits[at].placement; });
    std::stable_sort(positions.begin(), positions.end(), [&](std::uint32_t a, std::uint32_t b) {
        return fits[a].placement->distance < fits[b].placement->distance;
    });
    if (positions.size() > count) positions.resize(count);
    std::vector<mesh::TriangleMesh> meshes(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const auto preview = store.preview(question.snapshot.id(positions[i]));
        if (preview) meshes[i] = mesh_of(*preview);
    }
    const ranking::RankOptions& options = question.options.rank;
    parallel_for(positions.size(), options.jobs, [&](std::size_t i) {
        if (options.stop.stop_requested() || meshes[i].triangles.empty()) return;
        PartFit& fit = fits[positions[i]];
        fit.placement = registration::settle_piece(*question.piece, meshes[i], *fit.placement);
        fit.settled = true;
    });
    if (options.stop.stop_requested()) return part_cancelled();
    return {};
}

/// Of models with features that may be hits, the most alike first.
std::vector<std::uint32_t> most_alike(const Likeness& likeness,
                                      const std::vector<std::uint32_t>* among) {
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < likeness.positions.size(); ++i) {
        if (among == nullptr ||
            std::binary_search(among->begin(), among->end(), likeness.positions[i])) {
            order.push_back(i);
        }
    }
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return likeness.values[a] > likeness.values[b];
    });
    for (std::uint32_t& each : order) each = likeness.positions[each];
    return order;
}

/// The first `count` of them, ascending, and all positions without features.
std::vector<std::uint32_t> with_skeletons(const Likeness& likeness,
                                          const std::vector<std::uint32_t>& order,
                                          const std::vector<std::uint32_t>* among,
                                          std::size_t models, std::size_t count) {
    std::vector<std::uint32_t> all(models);
    std::iota(all.begin(), all.end(), 0U);
    if (among != nullptr) all = *among;
    std::vector<std::uint32_t> chosen;
    std::set_difference(all.begin(), all.end(), likeness.positions.begin(),
                        likeness.positions.end(), std::back_inserter(chosen));
    const auto taken = static_cast<std::ptrdiff_t>(std::min(count, order.size()));
    chosen.insert(chosen.end(), order.begin(), order.begin() + taken);
    std::sort(chosen.begin(), chosen.end());
    return chosen;
}

mesh::MeshWarning features_missing(std::size_t models) {
    return {
        "features_missing", models,
        std::to_string(models) +
            " models have no features of their surface, since they were indexed before there "
            "were any or have no area, and are found by their skeletons alone; index the folder "
            "once more"};
}

}  // namespace

std::vector<matching::DistancePart> PartFit::shares() const {
    double apart = 1.0;
    if (placement) {
        apart = settled ? kElsewhere * placement->distance
                        : kElsewhere + (1.0 - kElsewhere) * placement->distance;
    }
    return {{"placement", 0.5 * apart},
            {"features", 0.5 * apart * (1.0 - kSkeletonShare) * features},
            {"skeleton", 0.5 * apart * kSkeletonShare * skeleton}};
}

double PartFit::distance() const {
    double sum = 0.0;
    for (const matching::DistancePart& share : shares()) sum += share.value;
    return sum;
}

Result<PartFits> part_fits(const Question& question, Store& store,
                           const std::vector<std::uint32_t>* among,
                           const PartSearchOptions& options) {
    const std::size_t models = question.snapshot.size();
    const auto likeness = likeness_of(question, store);
    if (!likeness) return likeness.error();
    PartFits result;
    result.complete = likeness->complete;
    result.without_features = models - likeness->positions.size();
    result.fits.resize(models);
    for (std::size_t i = 0; i < likeness->positions.size(); ++i) {
        result.fits[likeness->positions[i]].features = 1.0 - likeness->values[i];
    }
    std::vector<std::uint32_t> order = most_alike(*likeness, among);
    const std::size_t skeletons =
        models <= options.all_skeletons ? order.size() : options.skeletons;
    const auto matched = match_skeletons(
        question, with_skeletons(*likeness, order, among, models, skeletons), result.fits);
    if (!matched) return matched.error();
    const std::size_t placed_models =
        models <= options.all_skeletons ? options.placed_of_few : options.placed;
    if (order.size() > placed_models) order.resize(placed_models);
    if (const auto placed = place(question, store, order, result.fits); !placed) {
        return placed.error();
    }
    if (const auto done = settle(question, store, order, options.settled, result.fits); !done) {
        return done.error();
    }
    return result;
}

Result<Found> find_parts(const Question& question, Store& store) {
    const Snapshot& snapshot = question.snapshot;
    Stopwatch watch;
    const StageReport& on_stage = question.options.on_stage;
    if (on_stage) on_stage("rank");
    const auto among = looked_among(snapshot, store, question.options);
    if (!among) return among.error();
    const auto fits = part_fits(question, store, *among ? &**among : nullptr);
    if (!fits) return fits.error();
    std::vector<ranking::RankedModel> models;
    const auto add = [&](std::size_t at) { models.push_back({at, fits->fits[at].distance()}); };
    if (*among) {
        for (const std::uint32_t at : **among) add(at);
    } else {
        for (std::size_t at = 0; at < snapshot.size(); ++at) add(at);
    }
    std::stable_sort(models.begin(), models.end(),
                     [](const auto& a, const auto& b) { return a.distance < b.distance; });
    Found found;
    found.complete = fits->complete;
    std::vector<std::uint32_t> positions;
    if (auto done = add_hits(question, store, wanted(question, models), positions, found); !done) {
        return done.error();
    }
    std::map<ModelId, const PartFit*> fit_of;
    for (const std::uint32_t at : positions) fit_of[snapshot.id(at)] = &fits->fits[at];
    found.stages_ms.push_back({"rank", watch.lap_ms()});
    if (question.options.with_match) {
        if (on_stage) on_stage("explain");
        if (auto done = explain_hits(question, positions, found.hits); !done) return done.error();
        found.stages_ms.push_back({"explain", watch.lap_ms()});
    }
    for (Hit& hit : found.hits) {
        const PartFit& fit = *fit_of.at(hit.id);
        hit.placement = fit.placement;
        if (question.options.with_match) hit.parts = fit.shares();
    }
    if (fits->without_features > 0) {
        found.warnings.push_back(features_missing(fits->without_features));
    }
    finish(question, found);
    return found;
}

}  // namespace ossuary::index
