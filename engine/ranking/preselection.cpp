#include "engine/ranking/preselection.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <numeric>

#include "engine/core/parallel.h"
#include "engine/descriptor/byte_distance.h"
#include "engine/ranking/cancelled.h"
#include "engine/ranking/near_search.h"

namespace ossuary::ranking {
namespace {

/// Models that one thread scans at a time.
constexpr std::size_t kScanned = 16384;

using Distance = std::uint16_t;
static_assert(descriptor::kSignatureSize * 255 <= std::numeric_limits<Distance>::max());

/// The places of the `count` least distances, ascending; of equal ones the first. Counting the few
/// distances that there are takes a sixth of the time of std::nth_element.
std::vector<std::uint32_t> least(const std::vector<Distance>& distances, std::size_t count) {
    std::vector<std::uint32_t> places;
    const std::size_t kept = std::min(count, distances.size());
    if (kept == 0) return places;
    std::vector<std::uint32_t> models(std::numeric_limits<Distance>::max() + 1UL, 0);
    for (const Distance distance : distances) ++models[distance];
    std::size_t last = 0, before = 0;
    while (before + models[last] < kept) before += models[last++];
    std::size_t of_last = kept - before;
    places.reserve(kept);
    for (std::size_t i = 0; i < distances.size(); ++i) {
        if (distances[i] > last || (distances[i] == last && of_last == 0)) continue;
        if (distances[i] == last) --of_last;
        places.push_back(static_cast<std::uint32_t>(i));
    }
    return places;
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

/// Every model that may be a hit, or that others are re-ranked by, measured by blocks.
Result<std::vector<RankedModel>> measure_all(NearSearch& search, std::size_t size,
                                             const RankOptions& options,
                                             const NearestOptions& nearest) {
    std::vector<RankedModel> models;
    // With re-ranking all places are found before those that may be hits are taken.
    const bool chosen_last = options.rerank && nearest.among;
    if (nearest.among && !chosen_last) {
        for (const std::uint32_t i : *nearest.among) models.push_back({i, 0.0});
    } else {
        models.resize(size);
        for (std::size_t i = 0; i < size; ++i) models[i].index = i;
    }
    if (auto measured = search.measure(models); !measured) return measured.error();
    if (options.rerank) {
        keep_nearest(models, models.size());
        if (auto done = search.rerank_models(models); !done) return done.error();
    }
    if (chosen_last) {
        std::erase_if(models, [&](const RankedModel& model) {
            return !std::binary_search(nearest.among->begin(), nearest.among->end(), model.index);
        });
    }
    return models;
}

Result<std::vector<RankedModel>> measure_nearest(NearSearch& search,
                                                 const descriptor::ModelDescriptor& query,
                                                 const Preselection& preselection,
                                                 const RankOptions& options,
                                                 const NearestOptions& nearest) {
    std::vector<RankedModel> models;
    for (const std::uint32_t index :
         preselection.nearest(query.signature, nearest.by_signature, nearest.among, options.jobs)) {
        models.push_back({index, 0.0});
    }
    search.sketch(models, preselection);
    keep_nearest(models, nearest.by_sketch);
    if (auto done = search.measure(models); !done) return done.error();
    if (options.rerank) {
        keep_nearest(models, models.size());
        if (auto done = search.rerank_models(models); !done) return done.error();
    }
    return models;
}

}  // namespace

Preselection::Preselection(std::vector<const ScanRows*> blocks) : blocks_(std::move(blocks)) {
    first_.reserve(blocks_.size() + 1);
    first_.push_back(0);
    for (const ScanRows* block : blocks_) first_.push_back(first_.back() + block->size());
}

std::size_t Preselection::block_of(std::uint32_t index) const {
    assert(index < size());
    return static_cast<std::size_t>(std::upper_bound(first_.begin(), first_.end(), index) -
                                    first_.begin()) -
           1;
}

ScanRow Preselection::row(std::uint32_t index) const {
    const std::size_t block = block_of(index);
    return blocks_[block]->row(index - first_[block]);
}

std::vector<std::uint16_t> Preselection::distances(
    std::span<const std::uint8_t> query, std::optional<std::span<const std::uint32_t>> among,
    int jobs) const {
    std::vector<Distance> distances(among ? among->size() : size());
    const auto scan = [&](std::size_t begin, std::size_t end) {
        std::size_t block = 0;
        for (std::size_t k = begin; k < end; ++k) {
            const std::size_t i = among ? (*among)[k] : k;
            if (k == begin) block = block_of(static_cast<std::uint32_t>(i));
            while (i >= first_[block + 1]) ++block;
            const std::uint8_t* signature = blocks_[block]->signatures.data() +
                                            (i - first_[block]) * descriptor::kSignatureSize;
            distances[k] = static_cast<Distance>(
                descriptor::byte_distance(query.data(), signature, descriptor::kSignatureSize));
        }
    };
    parallel_for((distances.size() + kScanned - 1) / kScanned, jobs, [&](std::size_t part) {
        scan(part * kScanned, std::min(distances.size(), (part + 1) * kScanned));
    });
    return distances;
}

std::vector<std::uint32_t> Preselection::nearest(
    std::span<const float> signature, std::size_t count,
    std::optional<std::span<const std::uint32_t>> among, int jobs) const {
    std::vector<std::uint32_t> places =
        least(distances(signature_bytes(signature), among, jobs), count);
    if (among) {
        for (std::uint32_t& place : places) place = (*among)[place];
    }
    return places;
}

namespace {

/// Finalists for one model that is wanted, where very many are.
constexpr std::size_t kFinalistsForOne = 4;

// Of the width of stages see docs/performance.md.
constexpr std::size_t kBySignature = 8000, kBySketch = 160;
/// In larger collections, a share of the models.
constexpr std::size_t kShareBySignature = 25;

}  // namespace

NearestOptions with_widths(NearestOptions nearest, std::size_t models) {
    const std::size_t finalists = kFinalistsForOne * nearest.count;
    if (nearest.by_signature == 0) {
        nearest.by_signature = std::max(kBySignature, models / kShareBySignature);
    }
    if (nearest.by_sketch == 0) nearest.by_sketch = kBySketch;
    nearest.by_sketch = std::max(nearest.by_sketch, finalists);
    nearest.by_signature = std::max(nearest.by_signature, 8 * finalists);
    return nearest;
}

bool measures_all(std::size_t models, const RankOptions& options, const NearestOptions& nearest) {
    return options.part || options.ranker == RankerKind::kChainCode ||
           models <= nearest.exhaustive_below || nearest.count > models / kFinalistsForOne ||
           (options.rerank && nearest.among);
}

Result<std::vector<RankedModel>> nearest_models(const descriptor::ModelDescriptor& query,
                                                DescriptorSource& collection,
                                                const Preselection& preselection,
                                                const Normalization& normalization,
                                                const RankOptions& options,
                                                const NearestOptions& nearest) {
    const bool all = measures_all(collection.size(), options, nearest);
    assert(all || preselection.size() == collection.size());
    NearSearch search(query, collection, normalization, options);
    if (auto ready = search.judge_query(all); !ready) return ready.error();
    auto models = all ? measure_all(search, collection.size(), options, nearest)
                      : measure_nearest(search, query, preselection, options,
                                        with_widths(nearest, collection.size()));
    if (!models) return models;
    if (options.stop.stop_requested()) return cancelled();
    keep_nearest(*models, nearest.count + nearest.spare);
    return models;
}

}  // namespace ossuary::ranking
