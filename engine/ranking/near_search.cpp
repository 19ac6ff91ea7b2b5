#include "engine/ranking/near_search.h"

#include <algorithm>
#include <numeric>

#include "engine/core/parallel.h"
#include "engine/ranking/each_with_meter.h"
#include "engine/ranking/part_search.h"
#include "engine/ranking/rerank.h"

namespace ossuary::ranking {
namespace {

/// Descriptors that are in use at a time: some 20 MB of them.
constexpr std::size_t kModelsInUse = 1024;

/// The pose costs too much to be measured before the finalists are known: those are models of the
/// query's kind, among which the pose then decides.
RankOptions without_pose(RankOptions options) {
    options.pose = std::min(options.pose, kDefaultPose);
    return options;
}

/// The pairs of the skeleton's points stand in for the tree edit distance.
FusionSide without_tree_edit(FusionSide side) {
    side.weights[1] += side.weights[0];
    side.weights[0] = 0.0;
    return side;
}

std::vector<std::uint32_t> indices_of(std::span<const RankedModel> models) {
    std::vector<std::uint32_t> indices(models.size());
    std::transform(models.begin(), models.end(), indices.begin(), [](const RankedModel& model) {
        return static_cast<std::uint32_t>(model.index);
    });
    return indices;
}

/// Takes out those that are gone.
void keep(std::vector<RankedModel>& models, const std::vector<bool>& gone) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < models.size(); ++i) {
        if (!gone[i]) models[kept++] = models[i];
    }
    models.resize(kept);
}

}  // namespace

NearSearch::NearSearch(const descriptor::ModelDescriptor& query, DescriptorSource& collection,
                       const Normalization& normalization, const RankOptions& options)
    : query_(query),
      collection_(collection),
      normalization_(normalization),
      options_(options),
      sketch_options_(without_pose(options)) {}

Result<void> NearSearch::judge_query(bool exhaustive) {
    if (options_.part || options_.ranker == RankerKind::kChainCode) return {};
    ModelScale scale = normalization_.pooled();
    if (const ModelScale* own = normalization_.find(query_)) {
        scale = *own;
    } else if (2 * collection_.size() >= normalization_.collection_size()) {
        std::vector<std::uint32_t> indices;
        for (const std::size_t i : judging_models(collection_.size())) {
            indices.push_back(static_cast<std::uint32_t>(i));
        }
        const auto references = collection_.fetch(indices);
        if (!references) return references.error();
        const RankOptions& options = exhaustive ? options_ : sketch_options_;
        std::vector<ComponentValues> row(references->size());
        for_each_with_meter(row.size(), options, [&](PairMeter& meter, std::size_t i) {
            if ((*references)[i]) row[i] = meter.components(query_, *(*references)[i]);
        });
        std::vector<ComponentValues> there;
        for (std::size_t i = 0; i < row.size(); ++i) {
            if ((*references)[i]) there.push_back(row[i]);
        }
        scale = scale_of_row(there, normalization_.pooled());
    }
    side_ = fusion_side(query_, scale, options_);
    sketch_side_ = without_tree_edit(fusion_side(query_, scale, sketch_options_));
    return {};
}

void NearSearch::sketch(std::vector<RankedModel>& models, const Preselection& preselection) const {
    const Sketch query = sketch_of(query_.globals);
    constexpr std::size_t kAtOnce = 1024;
    parallel_for((models.size() + kAtOnce - 1) / kAtOnce, options_.jobs, [&](std::size_t part) {
        const std::size_t end = std::min(models.size(), (part + 1) * kAtOnce);
        for (std::size_t i = part * kAtOnce; i < end; ++i) {
            const ScanRow row = preselection.row(static_cast<std::uint32_t>(models[i].index));
            const ModelScale* own = normalization_.find(row.key);
            const FusionSide side = without_tree_edit(
                fusion_side(static_cast<double>(row.information),
                            own != nullptr ? *own : normalization_.pooled(), sketch_options_));
            models[i].distance = fused_distance(
                sketch_components(query, row.sketch, sketch_options_), sketch_side_, side);
        }
    });
}

FusionSide NearSearch::side_of(const descriptor::ModelDescriptor& model) const {
    return fusion_side(model, normalization_.scale(model), options_);
}

double NearSearch::whole_distance(PairMeter& meter,
                                  const descriptor::ModelDescriptor& model) const {
    if (options_.ranker == RankerKind::kChainCode) return meter.chain_code(query_, model);
    return fused_distance(meter.components(query_, model), side_, side_of(model));
}

Result<void> NearSearch::measure(std::vector<RankedModel>& models) {
    if (options_.part) return measure_parts(models);
    std::vector<bool> gone(models.size(), false);
    for (std::size_t begin = 0; begin < models.size(); begin += kModelsInUse) {
        if (options_.stop.stop_requested()) return {};
        const std::span<RankedModel> block =
            std::span(models).subspan(begin, std::min(kModelsInUse, models.size() - begin));
        const auto descriptors = collection_.fetch(indices_of(block));
        if (!descriptors) return descriptors.error();
        for_each_with_meter(block.size(), options_, [&](PairMeter& meter, std::size_t i) {
            const SharedDescriptor& model = (*descriptors)[i];
            if (model) block[i].distance = whole_distance(meter, *model);
        });
        for (std::size_t i = 0; i < block.size(); ++i) gone[begin + i] = !(*descriptors)[i];
    }
    keep(models, gone);
    return {};
}

Result<void> NearSearch::measure_parts(std::vector<RankedModel>& models) {
    std::vector<bool> gone(models.size(), false);
    for (std::size_t begin = 0; begin < models.size(); begin += kModelsInUse) {
        const std::span<RankedModel> block =
            std::span(models).subspan(begin, std::min(kModelsInUse, models.size() - begin));
        const auto descriptors = collection_.fetch(indices_of(block));
        if (!descriptors) return descriptors.error();
        std::vector<const descriptor::ModelDescriptor*> there;
        std::vector<std::size_t> places;
        for (std::size_t i = 0; i < block.size(); ++i) {
            gone[begin + i] = !(*descriptors)[i];
            if (!(*descriptors)[i]) continue;
            there.push_back((*descriptors)[i].get());
            places.push_back(i);
        }
        const auto distances = part_distances(query_, there, options_);
        if (!distances) return distances.error();
        for (std::size_t i = 0; i < places.size(); ++i) {
            block[places[i]].distance = (*distances)[i];
        }
    }
    keep(models, gone);
    return {};
}

Result<void> NearSearch::rerank_models(std::vector<RankedModel>& models) {
    // Only the first of them change places, and only these are asked for.
    const std::size_t head = std::min(models.size(), RerankOptions{}.depth);
    const auto descriptors = collection_.fetch(indices_of(std::span(models).first(head)));
    if (!descriptors) return descriptors.error();
    std::vector<double> distances;
    for (const RankedModel& model : models) distances.push_back(model.distance);
    const auto among = [&](std::size_t i, std::span<const std::size_t> others) {
        PairMeter meter(options_);
        std::vector<double> row(others.size());
        const SharedDescriptor& own = (*descriptors)[i];
        if (!own) return row;
        const bool chain_code = options_.ranker == RankerKind::kChainCode;
        const FusionSide side = chain_code ? FusionSide() : side_of(*own);
        for (std::size_t k = 0; k < others.size() && !options_.stop.stop_requested(); ++k) {
            const SharedDescriptor& other = (*descriptors)[others[k]];
            if (!other) continue;
            row[k] = chain_code
                         ? meter.chain_code(*own, *other)
                         : fused_distance(meter.components(*own, *other), side, side_of(*other));
        }
        return row;
    };
    distances = rerank(distances, among, {}, options_.jobs);
    for (std::size_t i = 0; i < models.size(); ++i) models[i].distance = distances[i];
    return {};
}

}  // namespace ossuary::ranking
