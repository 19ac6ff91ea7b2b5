#include "index/searcher.h"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <set>
#include <tuple>

#include "engine/core/mutex.h"
#include "engine/descriptor/describe.h"
#include "engine/ranking/explain.h"
#include "index/catalogue.h"
#include "index/descriptor_cache.h"

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

/// What is asked of one snapshot.
struct Question {
    const Snapshot& snapshot;
    SnapshotDescriptors& descriptors;
    const descriptor::ModelDescriptor& query;
    const SearchOptions& options;
    ModelId left_out = 0;
};

ranking::NearestOptions nearest_options(const Snapshot& snapshot, const SearchOptions& options) {
    // One more, because the model that is left out is among the nearest.
    ranking::NearestOptions nearest;
    nearest.count = options.limit == 0 ? snapshot.size() : options.limit + 1;
    return nearest;
}

/// The positions of the models that may be hits, ascending; none where all may.
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
    std::vector<ranking::RankedModel> hits;
    std::set<std::uint64_t> seen;
    for (const ranking::RankedModel& found : *models) {
        if (snapshot.id(found.index) == question.left_out) continue;
        if (options.fold_copies && !seen.insert(snapshot.measures(found.index)).second) continue;
        hits.push_back(found);
        if (hits.size() == options.limit) break;
    }
    return hits;
}

/// Parts and correspondences of hits; those whose descriptors are gone go, too.
Result<void> explain_hits(const Question& question, std::span<const std::uint32_t> positions,
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

/// What a search has found, without its query.
struct Found {
    std::vector<Hit> hits;
    StageTimes stages_ms;
    std::size_t models = 0;
    Revision revision = 0;
    bool complete = true;  ///< nothing was missing that the snapshot knows of

    void move_into(SearchResult& result) && {
        result.hits = std::move(hits);
        result.stages_ms = std::move(stages_ms);
        result.models = models;
        result.revision = revision;
    }
};

/// Ranks the snapshot for a query and explains the hits.
Result<Found> find_hits(const Question& question, Store& store) {
    const Snapshot& snapshot = question.snapshot;
    Found result;
    Stopwatch watch;
    const StageReport& on_stage = question.options.on_stage;
    if (on_stage) on_stage("rank");
    const auto models = ranked(question, store);
    if (!models) return models.error();
    std::vector<std::uint32_t> positions;
    std::vector<std::uint64_t> measures;
    for (const ranking::RankedModel& found : *models) {
        auto model = store.model(snapshot.id(found.index));
        if (!model && model.error().code != ErrorCode::kModelNotFound) return model.error();
        if (!model) {
            result.complete = false;
            continue;
        }
        positions.push_back(static_cast<std::uint32_t>(found.index));
        measures.push_back(snapshot.measures(found.index));
        Hit hit;
        hit.id = model->id;
        hit.name = std::move(model->name);
        hit.class_name = std::move(model->class_name);
        hit.path = std::move(model->path);
        hit.faces = model->faces;
        hit.extent = model->bounds.sizes();
        hit.distance = found.distance;
        result.hits.push_back(std::move(hit));
    }
    const auto copies = snapshot.count_measures(measures);
    for (std::size_t i = 0; i < copies.size(); ++i) result.hits[i].copies = copies[i] - 1;
    result.stages_ms.push_back({"rank", watch.lap_ms()});
    if (question.options.with_match) {
        if (on_stage) on_stage("explain");
        if (auto done = explain_hits(question, positions, result.hits); !done) return done.error();
        result.stages_ms.push_back({"explain", watch.lap_ms()});
    }
    for (std::size_t i = 0; i < result.hits.size(); ++i) result.hits[i].rank = i + 1;
    result.models = snapshot.size();
    result.revision = snapshot.revision();
    result.complete = result.complete && !question.descriptors.missed();
    return result;
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
    auto match = ranking::explain(first->descriptor, second->descriptor, ranking::Normalization(),
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
    explicit Impl(Store opened) : store(std::move(opened)), pool(store) {}

    Store store;
    StorePool pool;
    DescriptorCache cache;
    std::timed_mutex loading;  ///< held by the one thread that loads a snapshot
    Mutex mutex;
    std::shared_ptr<const Snapshot> current OSSUARY_GUARDED_BY(mutex);

    std::shared_ptr<const Snapshot> known() {
        const Lock lock(mutex);
        return current;
    }
    Result<Found> nearest(const descriptor::ModelDescriptor& query, const SearchOptions& options,
                          ModelId left_out, std::shared_ptr<const Snapshot> snapshot,
                          Searcher& searcher);
};

/// How often a search is begun anew because models have changed under it.
constexpr int kAttempts = 3;
/// How long a search waits for a newer snapshot when there is an earlier one.
constexpr std::chrono::milliseconds kPatience(50);

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

StorePool& Searcher::stores() { return impl_->pool; }

Result<std::shared_ptr<const Snapshot>> Searcher::snapshot() {
    const auto is_current = [&]() -> Result<bool> {
        const auto state = impl_->store.collection_state();
        if (!state) return state.error();
        const auto known = impl_->known();
        return known && *state == known->state();
    };
    auto current = is_current();
    if (!current) return current.error();
    if (*current) return impl_->known();
    std::unique_lock loading(impl_->loading, std::defer_lock);
    const auto earlier = impl_->known();
    if (earlier) {
        // What has been read once is searched as it is, however much there is to be read.
        if (!loading.try_lock_for(kPatience)) return earlier;
    } else {
        loading.lock();
    }
    current = is_current();
    if (!current) return current.error();
    if (*current) return impl_->known();
    const auto store = impl_->pool.lend();
    if (!store) return store.error();
    auto loaded = Snapshot::load(**store, impl_->known().get());
    if (!loaded) return loaded;
    const Lock lock(impl_->mutex);
    impl_->current = *loaded;
    return loaded;
}

Result<DescribedQuery> Searcher::describe(const mesh::TriangleMesh& query, std::stop_token stop,
                                          const StageReport& on_stage) {
    descriptor::DescribeOptions options = describe_options(impl_->store.parameters());
    options.skeletonize.on_stage = on_stage;
    auto description = descriptor::describe(query, options, std::move(stop));
    if (!description) return description.error();
    DescribedQuery described;
    described.skeleton =
        with_chain_codes(std::move(description->skeleton), description->descriptor.skeleton);
    described.descriptor = std::move(description->descriptor);
    described.body = std::move(description->body);
    described.warnings = std::move(description->warnings);
    described.stages_ms = std::move(description->stage_times);
    return described;
}

Result<Found> Searcher::Impl::nearest(const descriptor::ModelDescriptor& query,
                                      const SearchOptions& options, ModelId left_out,
                                      std::shared_ptr<const Snapshot> snapshot,
                                      Searcher& searcher) {
    for (int attempt = 1;; ++attempt) {
        const bool all = ranking::measures_all(snapshot->size(), options.rank,
                                               nearest_options(*snapshot, options));
        // A pass over a large collection would leave nothing else in the cache.
        const bool kept = !all || snapshot->size() <= ranking::NearestOptions{}.exhaustive_below;
        SnapshotDescriptors descriptors(*snapshot, pool, kept ? &cache : nullptr,
                                        options.rank.jobs);
        const auto reader = pool.lend();
        if (!reader) return reader.error();
        auto found = find_hits({*snapshot, descriptors, query, options, left_out}, **reader);
        if (!found || found->complete || attempt == kAttempts) return found;
        auto later = searcher.snapshot();
        if (!later) return later.error();
        snapshot = *std::move(later);
    }
}

Result<SearchResult> Searcher::nearest(const DescribedQuery& query, const SearchOptions& options,
                                       std::stop_token stop) {
    if (const auto checked = check_rank_options(options.rank); !checked) return checked.error();
    const Stopwatch total;
    const auto loaded = snapshot();
    if (!loaded) return loaded.error();
    SearchOptions search = options;
    search.rank = stoppable(options.rank, std::move(stop));
    auto found = impl_->nearest(query.descriptor, search, 0, *loaded, *this);
    if (!found) return found.error();
    SearchResult result;
    std::move(*found).move_into(result);
    result.took_ms = total.elapsed_ms();
    return result;
}

Result<SearchResult> Searcher::search(const mesh::TriangleMesh& query, const SearchOptions& options,
                                      std::stop_token stop) {
    if (const auto checked = check_rank_options(options.rank); !checked) return checked.error();
    const Stopwatch total;
    // Loaded before the query is described: a damaged index is told at once.
    if (const auto loaded = snapshot(); !loaded) return loaded.error();
    auto described = describe(query, stop, options.on_stage);
    if (!described) return described.error();
    auto result = nearest(*described, options, std::move(stop));
    if (!result) return result.error();
    result->stages_ms.insert(result->stages_ms.begin(), described->stages_ms.begin(),
                             described->stages_ms.end());
    result->query_skeleton = std::move(described->skeleton);
    result->query_body = std::move(described->body);
    result->warnings = std::move(described->warnings);
    result->took_ms = total.elapsed_ms();
    return result;
}

Result<SearchResult> Searcher::similar(ModelId id, const SearchOptions& options,
                                       std::stop_token stop) {
    if (const auto checked = check_rank_options(options.rank); !checked) return checked.error();
    const Stopwatch total;
    auto found = consistent({id});
    if (!found) return found.error();
    SearchOptions search = options;
    search.rank = stoppable(options.rank, std::move(stop));
    auto hits = impl_->nearest(*found->descriptors.front(), search, id, found->snapshot, *this);
    if (!hits) return hits.error();
    const auto model = impl_->store.model(id);
    if (!model) return model.error();
    SearchResult result;
    std::move(*hits).move_into(result);
    result.query_skeleton = std::move(found->skeletons.front());
    result.warnings = model->warnings;
    result.took_ms = total.elapsed_ms();
    return result;
}

Result<Comparison> Searcher::compare(ModelId a, ModelId b, const ranking::RankOptions& options,
                                     std::stop_token stop) {
    if (const auto checked = check_rank_options(options); !checked) return checked.error();
    auto found = consistent({a, b});
    if (!found) return found.error();
    auto match =
        ranking::explain(*found->descriptors[0], *found->descriptors[1],
                         found->snapshot->normalization(), stoppable(options, std::move(stop)));
    if (!match) return match.error();
    Comparison comparison;
    comparison.match = *std::move(match);
    for (const auto& [side, id, i] :
         {std::tuple(&comparison.a, a, 0U), std::tuple(&comparison.b, b, 1U)}) {
        auto model = impl_->store.model(id);
        if (!model) return model.error();
        *side = {*std::move(model), std::move(found->skeletons[i])};
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
            SnapshotDescriptors source(*found.snapshot, impl_->pool, &impl_->cache);
            const std::uint32_t positions[] = {static_cast<std::uint32_t>(*position)};
            const auto fetched = source.fetch(positions);
            if (!fetched) return fetched.error();
            auto skeleton = impl_->store.skeleton(id);
            if (!skeleton && attempt >= 3) return skeleton.error();
            if (!skeleton || !fetched->front()) break;
            const auto& descriptor = fetched->front()->skeleton;
            if (skeleton->graph.nodes.size() != descriptor.nodes.size() ||
                skeleton->graph.branches.size() != descriptor.branches.size()) {
                break;
            }
            found.descriptors.push_back(fetched->front());
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
