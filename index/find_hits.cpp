#include "index/find_hits.h"

#include <set>
#include <utility>

#include "engine/ranking/explain.h"
#include "index/catalogue.h"

namespace ossuary::index {

namespace {

/// The models that may be hits, nearest first.
Result<std::vector<ranking::RankedModel>> ranked(const Question& question, Store& store) {
    const Snapshot& snapshot = question.snapshot;
    const SearchOptions& options = question.options;
    // Distances do not depend on what is looked for among: they are judged by the whole collection.
    ranking::NearestOptions nearest = nearest_options(snapshot, options);
    // Each copy may take a place that another model is to have; in large collections that are
    // mostly copies the list may then end early.
    if (options.fold_copies) nearest.spare = snapshot.size();
    const auto among = looked_among(snapshot, store, options);
    if (!among) return among.error();
    if (*among) {
        nearest.among = **among;
    }
    const auto models =
        ranking::nearest_models(question.query, question.descriptors, snapshot.preselection(),
                                snapshot.normalization(), options.rank, nearest);
    if (!models) return models.error();
    return wanted(question, *models);
}

}  // namespace

void Found::move_into(SearchResult& result) && {
    result.hits = std::move(hits);
    result.stages_ms = std::move(stages_ms);
    result.warnings = std::move(warnings);
    result.models = models;
    result.revision = revision;
}

ranking::NearestOptions nearest_options(const Snapshot& snapshot, const SearchOptions& options) {
    // One more, because the model that is left out is among the nearest.
    ranking::NearestOptions nearest;
    nearest.count = options.limit == 0 ? snapshot.size() : options.limit + 1;
    return nearest;
}

Result<std::optional<std::vector<std::uint32_t>>> looked_among(const Snapshot& snapshot,
                                                               Store& store,
                                                               const SearchOptions& options) {
    using Positions = std::optional<std::vector<std::uint32_t>>;
    if (!options.folder && !options.kind) {
        if (options.class_filter.empty()) return Positions();
        return Positions(snapshot.of_class(options.class_filter));
    }
    CatalogueFilter filter{.folder = options.folder, .kind = options.kind};
    if (!options.class_filter.empty()) filter.class_name = options.class_filter;
    const auto listed = list_models(snapshot, store, filter, CatalogueOrder::kId);
    if (!listed) return listed.error();
    return Positions(std::in_place, listed->begin(), listed->end());
}

std::vector<ranking::RankedModel> wanted(const Question& question,
                                         const std::vector<ranking::RankedModel>& models) {
    const Snapshot& snapshot = question.snapshot;
    std::vector<ranking::RankedModel> hits;
    std::set<std::uint64_t> seen;
    for (const ranking::RankedModel& found : models) {
        if (snapshot.id(found.index) == question.left_out) continue;
        if (question.options.fold_copies && !seen.insert(snapshot.measures(found.index)).second) {
            continue;
        }
        hits.push_back(found);
        if (hits.size() == question.options.limit) break;
    }
    return hits;
}

Result<void> add_hits(const Question& question, Store& store,
                      const std::vector<ranking::RankedModel>& models,
                      std::vector<std::uint32_t>& positions, Found& found) {
    const Snapshot& snapshot = question.snapshot;
    std::vector<std::uint64_t> measures;
    for (const ranking::RankedModel& each : models) {
        auto model = store.model(snapshot.id(each.index));
        if (!model && model.error().code != ErrorCode::kModelNotFound) return model.error();
        if (!model) {
            found.complete = false;
            continue;
        }
        positions.push_back(static_cast<std::uint32_t>(each.index));
        measures.push_back(snapshot.measures(each.index));
        Hit hit;
        hit.id = model->id;
        hit.name = std::move(model->name);
        hit.class_name = std::move(model->class_name);
        hit.path = std::move(model->path);
        hit.faces = model->faces;
        hit.extent = model->bounds.sizes();
        hit.distance = each.distance;
        found.hits.push_back(std::move(hit));
    }
    const auto copies = snapshot.count_measures(measures);
    for (std::size_t i = 0; i < copies.size(); ++i) found.hits[i].copies = copies[i] - 1;
    return {};
}

Result<void> explain_hits(const Question& question, const std::vector<std::uint32_t>& positions,
                          std::vector<Hit>& hits) {
    const auto descriptors = question.descriptors.fetch(positions);
    if (!descriptors) return descriptors.error();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (!(*descriptors)[i]) continue;
        auto match = ranking::explain(question.query, *(*descriptors)[i],
                                      question.snapshot.normalization(), question.options.rank);
        if (!match) return match.error();
        Hit& hit = hits[i];
        hit.parts = std::move(match->parts);
        hit.matched_nodes = match->correspondence.nodes.size();
        hit.build = match->build;
        hit.pose = match->pose;
        hit.match = std::move(match->correspondence);
        if (kept != i) hits[kept] = std::move(hit);
        ++kept;
    }
    hits.resize(kept);
    return {};
}

void finish(const Question& question, Found& found) {
    for (std::size_t i = 0; i < found.hits.size(); ++i) found.hits[i].rank = i + 1;
    found.models = question.snapshot.size();
    found.revision = question.snapshot.revision();
    found.complete = found.complete && !question.descriptors.missed();
}

Result<Found> find_hits(const Question& question, Store& store) {
    if (question.options.rank.part && question.piece != nullptr) return find_parts(question, store);
    Found found;
    Stopwatch watch;
    const StageReport& on_stage = question.options.on_stage;
    if (on_stage) on_stage("rank");
    const auto models = ranked(question, store);
    if (!models) return models.error();
    std::vector<std::uint32_t> positions;
    if (auto done = add_hits(question, store, *models, positions, found); !done) {
        return done.error();
    }
    found.stages_ms.push_back({"rank", watch.lap_ms()});
    if (question.options.with_match) {
        if (on_stage) on_stage("explain");
        if (auto done = explain_hits(question, positions, found.hits); !done) return done.error();
        found.stages_ms.push_back({"explain", watch.lap_ms()});
    }
    finish(question, found);
    return found;
}

}  // namespace ossuary::index
