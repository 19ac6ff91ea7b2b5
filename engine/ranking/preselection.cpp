#include "engine/ranking/preselection.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "engine/descriptor/byte_distance.h"
#include "engine/descriptor/signature.h"
#include "engine/ranking/cancelled.h"
#include "engine/ranking/each_with_meter.h"
#include "engine/ranking/fusion.h"
#include "engine/ranking/rerank.h"

namespace ossuary::ranking {
namespace {

/// A signature's values are at most 0.4 for the Princeton models.
constexpr float kByteScale = 600.0F;

std::uint8_t to_byte(float value) {
    return static_cast<std::uint8_t>(std::clamp(std::round(kByteScale * value), 0.0F, 255.0F));
}

void keep_nearest(std::vector<RankedModel>& models, std::size_t count) {
    const auto nearer = [](const RankedModel& a, const RankedModel& b) {
        return a.distance != b.distance ? a.distance < b.distance : a.index < b.index;
    };
    const std::size_t kept = std::min(count, models.size());
    std::partial_sort(models.begin(), models.begin() + static_cast<std::ptrdiff_t>(kept),
                      models.end(), nearer);
    models.resize(kept);
}

/// A search in a large collection: what its stages share.
class Search {
public:
    Search(const descriptor::ModelDescriptor& query, DescriptorSpan collection,
           const Normalization& normalization, const RankOptions& options)
        : query_(query),
          collection_(collection),
          normalization_(normalization),
          options_(options),
          cheap_options_(without_pose(options)),
          scale_(query_scale()),
          side_(fusion_side(query, scale_, options)),
          cheap_side_(without_tree_edit(fusion_side(query, scale_, cheap_options_))) {}

    /// The query's distance to each model, by all components or by the cheap ones alone.
    void measure(std::vector<RankedModel>& models, bool without_tree) const {
        const RankOptions& options = without_tree ? cheap_options_ : options_;
        for_each_with_meter(models.size(), options, [&](PairMeter& meter, std::size_t i) {
            const descriptor::ModelDescriptor& model = *collection_[models[i].index];
            const FusionSide own = side_of(models[i].index, options);
            models[i].distance = without_tree
                                     ? fused_distance(meter.cheap_components(query_, model),
                                                      cheap_side_, without_tree_edit(own))
                                     : fused_distance(meter.components(query_, model), side_, own);
        });
    }

    /// Re-ranks models that are sorted by distance.
    void rerank_models(std::vector<RankedModel>& models) const {
        std::vector<double> distances;
        for (const RankedModel& model : models) distances.push_back(model.distance);
        const auto among = [&](std::size_t i, std::span<const std::size_t> others) {
            PairMeter meter(options_);
            const std::size_t own = models[i].index;
            const FusionSide side = side_of(own, options_);
            std::vector<double> row(others.size());
            for (std::size_t k = 0; k < others.size() && !options_.stop.stop_requested(); ++k) {
                const std::size_t index = models[others[k]].index;
                row[k] = fused_distance(meter.components(*collection_[own], *collection_[index]),
                                        side, side_of(index, options_));
            }
            return row;
        };
        distances = rerank(distances, among, {}, options_.jobs);
        for (std::size_t i = 0; i < models.size(); ++i) models[i].distance = distances[i];
    }

private:
    /// As rank_distances has it: its own where known, else by its distances to the references.
    [[nodiscard]] ModelScale query_scale() const {
        if (const ModelScale* own = normalization_.find(query_)) return *own;
        const std::vector<std::size_t> references = reference_models(collection_.size());
        std::vector<ComponentValues> row(references.size());
        for_each_with_meter(references.size(), cheap_options_,
                            [&](PairMeter& meter, std::size_t i) {
                                row[i] = meter.components(query_, *collection_[references[i]]);
                            });
        return scale_of_row(row, normalization_.pooled());
    }

    [[nodiscard]] FusionSide side_of(std::size_t index, const RankOptions& options) const {
        const descriptor::ModelDescriptor& model = *collection_[index];
        return fusion_side(model, normalization_.scale(model), options);
    }

    /// The pose costs too much to be measured before the finalists are known: those are models of
    /// the query's kind, among which the pose then decides.
    static RankOptions without_pose(RankOptions options) {
        options.pose = std::min(options.pose, kDefaultPose);
        return options;
    }

    /// The pairs of the skeleton's points stand in for the tree edit distance.
    static FusionSide without_tree_edit(FusionSide side) {
        side.weights[1] += side.weights[0];
        side.weights[0] = 0.0;
        return side;
    }

    const descriptor::ModelDescriptor& query_;
    DescriptorSpan collection_;
    const Normalization& normalization_;
    const RankOptions& options_;
    RankOptions cheap_options_;
    ModelScale scale_;
    FusionSide side_, cheap_side_;
};

Result<std::vector<RankedModel>> all_models(const descriptor::ModelDescriptor& query,
                                            DescriptorSpan collection,
                                            const CollectionStatistics& statistics,
                                            const RankOptions& options,
                                            const NearestOptions& nearest) {
    const auto distances = rank_distances(query, collection, statistics, options);
    if (!distances) return distances.error();
    std::vector<RankedModel> models;
    if (nearest.among) {
        for (const std::uint32_t i : *nearest.among) models.push_back({i, (*distances)[i]});
    } else {
        for (std::size_t i = 0; i < distances->size(); ++i) models.push_back({i, (*distances)[i]});
    }
    keep_nearest(models, nearest.count + nearest.spare);
    return models;
}

}  // namespace

Preselection::Preselection(DescriptorSpan collection) : count_(collection.size()) {
    bytes_.resize(count_ * descriptor::kSignatureSize);
    for (std::size_t i = 0; i < count_; ++i) {
        const std::vector<float>& signature = collection[i]->signature;
        const std::size_t size = std::min(signature.size(), descriptor::kSignatureSize);
        for (std::size_t k = 0; k < size; ++k) {
            bytes_[i * descriptor::kSignatureSize + k] = to_byte(signature[k]);
        }
    }
}

std::vector<std::uint32_t> Preselection::nearest(
    std::span<const float> signature, std::size_t count,
    std::optional<std::span<const std::uint32_t>> among) const {
    std::vector<std::uint8_t> query(descriptor::kSignatureSize, 0);
    std::transform(signature.begin(),
                   signature.begin() + static_cast<std::ptrdiff_t>(
                                           std::min(signature.size(), descriptor::kSignatureSize)),
                   query.begin(), to_byte);
    // Distance and index in one number, so that selecting compares one.
    std::vector<std::uint64_t> order(among ? among->size() : count_);
    for (std::size_t k = 0; k < order.size(); ++k) {
        const std::size_t i = among ? (*among)[k] : k;
        assert(i < count_);
        const std::uint64_t distance =
            descriptor::byte_distance(query.data(), bytes_.data() + i * descriptor::kSignatureSize,
                                      descriptor::kSignatureSize);
        order[k] = distance << 32 | i;
    }
    const std::size_t kept = std::min(count, order.size());
    std::nth_element(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(kept), order.end());
    std::vector<std::uint32_t> indices;
    indices.reserve(kept);
    for (std::size_t i = 0; i < kept; ++i) {
        indices.push_back(static_cast<std::uint32_t>(order[i] & 0xFFFFFFFFULL));
    }
    std::sort(indices.begin(), indices.end());
    return indices;
}

Result<std::vector<RankedModel>> nearest_models(const descriptor::ModelDescriptor& query,
                                                DescriptorSpan collection,
                                                const Preselection& preselection,
                                                const CollectionStatistics& statistics,
                                                const RankOptions& options,
                                                const NearestOptions& nearest) {
    if (options.part || options.ranker == RankerKind::kChainCode ||
        collection.size() <= nearest.exhaustive_below || 10 * nearest.count > nearest.by_globals ||
        (options.rerank && nearest.among)) {
        return all_models(query, collection, statistics, options, nearest);
    }
    assert(preselection.size() == collection.size());
    const Normalization normalization(statistics);
    const Search search(query, collection, normalization, options);
    std::vector<RankedModel> models;
    for (const std::uint32_t index :
         preselection.nearest(query.signature, nearest.by_signature, nearest.among)) {
        models.push_back({index, 0.0});
    }
    search.measure(models, true);
    keep_nearest(models, nearest.by_globals);
    search.measure(models, false);
    if (options.rerank) {
        keep_nearest(models, models.size());
        search.rerank_models(models);
    }
    if (options.stop.stop_requested()) return cancelled();
    keep_nearest(models, nearest.count + nearest.spare);
    return models;
}

}  // namespace ossuary::ranking
