#include "index/searcher.h"

#include <algorithm>
#include <set>

#include "engine/core/mutex.h"
#include "engine/descriptor/describe.h"
#include "index/part_search.h"
#include "index/preview.h"

namespace ossuary::index {

namespace {

StoredSkeleton with_chain_codes(skeleton::SkeletonGraph graph,
                                const matching::SkeletonDescriptor& descriptor) {
    StoredSkeleton skeleton{std::move(graph), {}};
    for (const matching::SkeletonDescriptor::Branch& branch : descriptor.branches) {
        skeleton.chain_codes.push_back(branch.chain_code);
    }
    return skeleton;
}

/// The options with the stop token of one call.
ranking::RankOptions stoppable(ranking::RankOptions options, std::stop_token stop) {
    options.stop = std::move(stop);
    return options;
}

/// The models of a class, ascending.
std::vector<std::uint32_t> positions_of_class(const Snapshot& snapshot, const std::string& name) {
    std::vector<std::uint32_t> positions;
    for (std::uint32_t i = 0; !name.empty() && i < snapshot.size(); ++i) {
        if (snapshot.models()[i].class_name == name) positions.push_back(i);
    }
    return positions;
}

/// Of models that may be hits, nearest first, those that are.
std::vector<ranking::RankedModel> wanted(const Snapshot& snapshot,
                                         const std::vector<ranking::RankedModel>& models,
                                         const SearchOptions& options, ModelId left_out) {
    std::vector<ranking::RankedModel> hits;
    std::set<std::size_t> seen;
    for (const ranking::RankedModel& found : models) {
        if (snapshot.models()[found.index].id == left_out) continue;
        if (options.fold_copies && !seen.insert(snapshot.copies(found.index)).second) continue;
        hits.push_back(found);
        if (hits.size() == options.limit) break;
    }
    return hits;
}

/// The models that may be hits, nearest first.
Result<std::vector<ranking::RankedModel>> ranked(const Snapshot& snapshot,
                                                 const descriptor::ModelDescriptor& query,
                                                 const SearchOptions& options, ModelId left_out) {
    // One more, because the model that is left out is among the nearest. Distances do not depend on
    // the class that is looked for: they are judged by the whole collection.
    ranking::NearestOptions nearest;
    nearest.count = options.limit == 0 ? snapshot.size() : options.limit + 1;
    // Each copy may take a place that another model is to have; in large collections that are
    // mostly copies the list may then end early.
    if (options.fold_copies) nearest.spare = snapshot.redundant();
    const std::vector<std::uint32_t> of_class = positions_of_class(snapshot, options.class_filter);
    if (!options.class_filter.empty()) nearest.among = of_class;
    const auto models =
        ranking::nearest_models(query, snapshot.descriptors(), snapshot.preselection(),
                                snapshot.statistics(), options.rank, nearest);
    if (!models) return models.error();
    return wanted(snapshot, *models, options, left_out);
}

/// What is known of a hit without looking at the query.
Hit hit_of(const Snapshot& snapshot, const ranking::RankedModel& found, std::size_t rank) {
    const ModelSummary& model = snapshot.models()[found.index];
    Hit hit;
    hit.rank = rank;
    hit.id = model.id;
    hit.name = model.name;
    hit.class_name = model.class_name;
    hit.path = model.path;
    hit.faces = model.faces;
    hit.extent = model.bounds.sizes();
    hit.copies = snapshot.copy_count(snapshot.copies(found.index)) - 1;
    hit.distance = found.distance;
    return hit;
}

/// Ranks the snapshot for `query` and explains the hits; adds the stages to `result`.
Result<void> find_hits(const Snapshot& snapshot, const descriptor::ModelDescriptor& query,
                       const SearchOptions& options, ModelId left_out, SearchResult& result) {
    Stopwatch watch;
    const auto models = ranked(snapshot, query, options, left_out);
    if (!models) return models.error();
    for (const ranking::RankedModel& found : *models) {
        result.hits.push_back(hit_of(snapshot, found, result.hits.size() + 1));
    }
    result.stages_ms.push_back({"rank", watch.lap_ms()});
    if (options.with_match) {
        for (Hit& hit : result.hits) {
            const auto position = snapshot.find(hit.id);
            auto match = ranking::explain(query, *snapshot.descriptors()[*position],
                                          snapshot.statistics(), options.rank);
            if (!match) return match.error();
            hit.parts = std::move(match->parts);
            hit.matched_nodes = match->correspondence.nodes.size();
            hit.build = match->build;
            hit.pose = match->pose;
            hit.match = std::move(match->correspondence);
        }
        result.stages_ms.push_back({"explain", watch.lap_ms()});
    }
    result.models = snapshot.size();
    result.revision = snapshot.revision();
    return {};
}

/// The same for a part.
Result<void> find_parts(Store& store, const Snapshot& snapshot, const PartQuery& query,
                        const SearchOptions& options, ModelId left_out, SearchResult& result) {
    Stopwatch watch;
    const std::vector<std::uint32_t> of_class = positions_of_class(snapshot, options.class_filter);
    const auto found = part_fits(store, snapshot, query, options.rank, of_class);
    if (!found) return found.error();
    std::vector<ranking::RankedModel> models;
    for (std::size_t i = 0; i < snapshot.size(); ++i) {
        const std::string& name = snapshot.models()[i].class_name;
        if (!options.class_filter.empty() && name != options.class_filter) continue;
        models.push_back({i, found->fits[i].distance});
    }
    std::stable_sort(models.begin(), models.end(),
                     [](const auto& a, const auto& b) { return a.distance < b.distance; });
    for (const ranking::RankedModel& model : wanted(snapshot, models, options, left_out)) {
        result.hits.push_back(hit_of(snapshot, model, result.hits.size() + 1));
        Hit& hit = result.hits.back();
        const PartFit& fit = found->fits[model.index];
        hit.placement = fit.placement;
        if (!options.with_match) continue;
        auto match = ranking::explain(query.descriptor, *snapshot.descriptors()[model.index],
                                      snapshot.statistics(), options.rank);
        if (!match) return match.error();
        hit.parts = fit.shares;
        hit.matched_nodes = match->correspondence.nodes.size();
        hit.match = std::move(match->correspondence);
    }
    if (found->without_features > 0) {
        result.warnings.push_back(
            {"features_missing", found->without_features,
             std::to_string(found->without_features) +
                 " models have no features of their surface, since they were indexed before there "
                 "were any or have no area, and are found by their skeletons alone; index them "
                 "into a new file"});
    }
    result.stages_ms.push_back({"rank", watch.lap_ms()});
    result.models = snapshot.size();
    result.revision = snapshot.revision();
    return {};
}

Result<void> check_rank_options(const ranking::RankOptions& options) {
    if (!(options.pose >= 0.0 && options.pose <= 1.0)) {
        return {ErrorCode::kInvalidArgument,
                "pose: " + std::to_string(options.pose) + ", expected a number from 0 to 1"};
    }
    if (!(options.size >= 0.0 && options.size <= 1.0)) {
        return {ErrorCode::kInvalidArgument,
                "size: " + std::to_string(options.size) + ", expected a number from 0 to 1"};
    }
    if (options.part && options.rerank) {
        return {ErrorCode::kInvalidArgument,
                "rerank: not together with part; what holds the same part need not be alike"};
    }
    return {};
}

}  // namespace

Result<Comparison> compare_meshes(const mesh::TriangleMesh& a, const mesh::TriangleMesh& b,
                                  const IndexParameters& parameters,
                                  const ranking::RankOptions& options, std::stop_token stop) {
    if (const auto checked = check_rank_options(options); !checked) return checked.error();
    auto first = descriptor::describe(a, describe_options(parameters), stop);
    if (!first) return first.error();
    auto second = descriptor::describe(b, describe_options(parameters), stop);
    if (!second) return second.error();
    auto match = ranking::explain(first->descriptor, second->descriptor, {},
                                  stoppable(options, std::move(stop)));
    if (!match) return match.error();
    Comparison comparison;
    comparison.match = *std::move(match);
    comparison.a.skeleton =
        with_chain_codes(std::move(first->skeleton), first->descriptor.skeleton);
    comparison.b.skeleton =
        with_chain_codes(std::move(second->skeleton), second->descriptor.skeleton);
    return comparison;
}

struct Searcher::Impl {
    explicit Impl(Store opened) : store(std::move(opened)) {}

    Store store;
    Mutex mutex;
    std::shared_ptr<const Snapshot> current OSSUARY_GUARDED_BY(mutex);
};

Searcher::Searcher(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Searcher::Searcher(Searcher&&) noexcept = default;
Searcher& Searcher::operator=(Searcher&&) noexcept = default;
Searcher::~Searcher() = default;

Result<Searcher> Searcher::open(const std::filesystem::path& path, Access access) {
    auto store = Store::open(path, access);
    if (!store) return store.error();
    const int pipeline = store->parameters().pipeline;
    if (pipeline != kPipelineVersion) {
        return {ErrorCode::kIndexParameters,
                path.string() + ": models described by version " + std::to_string(pipeline) +
                    " of the pipeline, this program is version " +
                    std::to_string(kPipelineVersion) + "; index them into a new file"};
    }
    return Searcher(std::make_unique<Impl>(*std::move(store)));
}

Store& Searcher::store() { return impl_->store; }

Result<std::shared_ptr<const Snapshot>> Searcher::snapshot() {
    const Lock lock(impl_->mutex);
    if (impl_->current) {
        const auto state = impl_->store.collection_state();
        if (!state) return state.error();
        if (*state == impl_->current->state()) return impl_->current;
    }
    auto loaded = Snapshot::load(impl_->store, impl_->current.get());
    if (loaded) impl_->current = *loaded;
    return loaded;
}

Result<DescribedQuery> Searcher::describe(const mesh::TriangleMesh& query, std::stop_token stop) {
    auto description =
        descriptor::describe(query, describe_options(impl_->store.parameters()), std::move(stop));
    if (!description) return description.error();
    DescribedQuery described;
    described.skeleton =
        with_chain_codes(std::move(description->skeleton), description->descriptor.skeleton);
    described.descriptor = std::move(description->descriptor);
    described.body = std::move(description->body);
    described.piece = registration::piece_query(described.body.of(query));
    described.warnings = std::move(description->warnings);
    described.stages_ms = std::move(description->stage_times);
    return described;
}

Result<SearchResult> Searcher::nearest(const DescribedQuery& query, const SearchOptions& options,
                                       std::stop_token stop) {
    if (const auto checked = check_rank_options(options.rank); !checked) return checked.error();
    const Stopwatch total;
    const auto loaded = snapshot();
    if (!loaded) return loaded.error();
    SearchOptions search = options;
    search.rank = stoppable(options.rank, std::move(stop));
    SearchResult result;
    const auto found =
        search.rank.part
            ? find_parts(impl_->store, **loaded, {query.descriptor, query.piece}, search, 0, result)
            : find_hits(**loaded, query.descriptor, search, 0, result);
    if (!found) return found.error();
    result.took_ms = total.elapsed_ms();
    return result;
}

Result<SearchResult> Searcher::search(const mesh::TriangleMesh& query, const SearchOptions& options,
                                      std::stop_token stop) {
    if (const auto checked = check_rank_options(options.rank); !checked) return checked.error();
    const Stopwatch total;
    // Loaded before the query is described: a damaged index is told at once.
    if (const auto loaded = snapshot(); !loaded) return loaded.error();
    auto described = describe(query, stop);
    if (!described) return described.error();
    auto result = nearest(*described, options, std::move(stop));
    if (!result) return result.error();
    result->stages_ms.insert(result->stages_ms.begin(), described->stages_ms.begin(),
                             described->stages_ms.end());
    result->query_skeleton = std::move(described->skeleton);
    result->query_body = std::move(described->body);
    result->warnings.insert(result->warnings.begin(), described->warnings.begin(),
                            described->warnings.end());
    result->took_ms = total.elapsed_ms();
    return result;
}

Result<SearchResult> Searcher::similar(ModelId id, const SearchOptions& options,
                                       std::stop_token stop) {
    if (const auto checked = check_rank_options(options.rank); !checked) return checked.error();
    const Stopwatch total;
    auto found = consistent({id});
    if (!found) return found.error();
    const Snapshot& models = *found->snapshot;
    const std::size_t position = *models.find(id);
    SearchOptions search = options;
    search.rank = stoppable(options.rank, std::move(stop));
    SearchResult result;
    const descriptor::ModelDescriptor& descriptor = *models.descriptors()[position];
    result.warnings = models.models()[position].warnings;
    if (options.rank.part) {
        const auto preview = impl_->store.preview(id);
        if (!preview) return preview.error();
        const registration::PieceQuery piece = registration::piece_query(mesh_of(*preview));
        const auto hits = find_parts(impl_->store, models, {descriptor, piece}, search, id, result);
        if (!hits) return hits.error();
    } else if (const auto hits = find_hits(models, descriptor, search, id, result); !hits) {
        return hits.error();
    }
    result.query_skeleton = std::move(found->skeletons.front());
    result.took_ms = total.elapsed_ms();
    return result;
}

Result<Comparison> Searcher::compare(ModelId a, ModelId b, const ranking::RankOptions& options,
                                     std::stop_token stop) {
    if (const auto checked = check_rank_options(options); !checked) return checked.error();
    auto found = consistent({a, b});
    if (!found) return found.error();
    const Snapshot& models = *found->snapshot;
    const std::size_t first = *models.find(a);
    const std::size_t second = *models.find(b);
    auto match = ranking::explain(*models.descriptors()[first], *models.descriptors()[second],
                                  models.statistics(), stoppable(options, std::move(stop)));
    if (!match) return match.error();
    Comparison comparison;
    comparison.match = *std::move(match);
    comparison.a = {models.models()[first], std::move(found->skeletons[0])};
    comparison.b = {models.models()[second], std::move(found->skeletons[1])};
    // A model is turned without a new revision, so the snapshot may not know.
    for (ComparedModel* each : {&comparison.a, &comparison.b}) {
        const auto now = impl_->store.model(each->summary.id);
        if (now) each->summary.orientation = now->orientation;
    }
    return comparison;
}

Result<Searcher::Consistent> Searcher::consistent(const std::vector<ModelId>& ids) {
    // A model may be replaced between the snapshot and the reading of its skeleton, whose nodes
    // would then not be those of the descriptor.
    for (int attempt = 0;; ++attempt) {
        Consistent found;
        const auto loaded = snapshot();
        if (!loaded) return loaded.error();
        found.snapshot = *loaded;
        for (const ModelId id : ids) {
            const auto position = found.snapshot->find(id);
            if (!position) {
                return {ErrorCode::kModelNotFound, "there is no model " + std::to_string(id)};
            }
            auto skeleton = impl_->store.skeleton(id);
            if (!skeleton && attempt >= 3) return skeleton.error();
            if (!skeleton) break;
            const auto& descriptor = found.snapshot->descriptors()[*position]->skeleton;
            if (skeleton->graph.nodes.size() != descriptor.nodes.size() ||
                skeleton->graph.branches.size() != descriptor.branches.size()) {
                break;
            }
            found.skeletons.push_back(*std::move(skeleton));
        }
        const auto state = impl_->store.collection_state();
        if (!state) return state.error();
        const bool unchanged = *state == found.snapshot->state();
        if (found.skeletons.size() == ids.size() && (unchanged || attempt >= 3)) return found;
        if (attempt >= 10) {
            return {ErrorCode::kIndexBusy, "the index changes faster than it can be read"};
        }
    }
}

}  // namespace ossuary::index
