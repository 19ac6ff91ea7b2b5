#include "index/searcher.h"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <tuple>

#include "engine/core/mutex.h"
#include "engine/descriptor/describe.h"
#include "engine/ranking/explain.h"
#include "index/descriptor_cache.h"
#include "index/find_hits.h"
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
    /// What is looked for.
    struct Sought {
        const descriptor::ModelDescriptor& query;
        const SearchOptions& options;
        ModelId left_out = 0;
        const registration::PieceQuery* piece = nullptr;
    };
    Result<Found> nearest(const Sought& sought, std::shared_ptr<const Snapshot> snapshot,
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

Result<Found> Searcher::Impl::nearest(const Sought& sought,
                                      std::shared_ptr<const Snapshot> snapshot,
                                      Searcher& searcher) {
    const SearchOptions& options = sought.options;
    for (int attempt = 1;; ++attempt) {
        const bool all = ranking::measures_all(snapshot->size(), options.rank,
                                               nearest_options(*snapshot, options));
        // A pass over a large collection would leave nothing else in the cache.
        const bool kept = !all || snapshot->size() <= ranking::NearestOptions{}.exhaustive_below;
        SnapshotDescriptors descriptors(*snapshot, pool, kept ? &cache : nullptr,
                                        options.rank.jobs);
        const auto reader = pool.lend();
        if (!reader) return reader.error();
        auto found = find_hits(
            {*snapshot, descriptors, sought.query, options, sought.left_out, sought.piece},
            **reader);
        if (!found || found->complete || attempt == kAttempts) return found;
        auto later = searcher.snapshot();
        if (!later) return later.error();
        snapshot = *std::move(later);
    }
}

Result<SearchResult> Searcher::nearest(const DescribedQuery& query, const SearchOptions& options,
                                       std::stop_token stop,
                                       const registration::PieceQuery* piece) {
    if (const auto checked = check_rank_options(options.rank); !checked) return checked.error();
    const Stopwatch total;
    const auto loaded = snapshot();
    if (!loaded) return loaded.error();
    SearchOptions search = options;
    search.rank = stoppable(options.rank, std::move(stop));
    auto found = impl_->nearest({query.descriptor, search, 0, piece}, *loaded, *this);
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
    Stopwatch watch;
    std::optional<registration::PieceQuery> piece;
    if (options.rank.part) {
        piece = registration::piece_query(described->body.of(query));
        described->stages_ms.push_back({"features", watch.lap_ms()});
    }
    auto result = nearest(*described, options, std::move(stop), piece ? &*piece : nullptr);
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
    SearchOptions search = options;
    search.rank = stoppable(options.rank, std::move(stop));
    std::optional<registration::PieceQuery> piece;
    if (options.rank.part) {
        const auto preview = impl_->store.preview(id);
        if (!preview) return preview.error();
        piece = registration::piece_query(mesh_of(*preview));
    }
    auto hits = impl_->nearest({*found->descriptors.front(), search, id, piece ? &*piece : nullptr},
                               found->snapshot, *this);
    if (!hits) return hits.error();
    const auto model = impl_->store.model(id);
    if (!model) return model.error();
    SearchResult result;
    std::move(*hits).move_into(result);
    result.query_skeleton = std::move(found->skeletons.front());
    result.warnings.insert(result.warnings.begin(), model->warnings.begin(), model->warnings.end());
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
