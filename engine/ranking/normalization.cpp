#include "engine/ranking/normalization.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <span>

#include "engine/core/parallel.h"
#include "engine/ranking/cancelled.h"

namespace ossuary::ranking {
namespace {

constexpr double kFormat = 3.0;
constexpr std::size_t kScaleSize = 2 * kComponentCount;
constexpr std::size_t kHeader = 3 + kScaleSize;
constexpr std::size_t kRecord = 2 + kScaleSize;
/// Distances are taken to at most this many models, fewer in large collections so that at most
/// kMaxPairs are measured, but no fewer than kLeastReferences.
constexpr std::size_t kMaxReferences = 500;
constexpr std::size_t kLeastReferences = 50;
constexpr std::size_t kMaxPairs = 1'000'000;
/// Larger collections keep the pooled scale alone.
constexpr std::size_t kMaxKnown = kMaxPairs / kLeastReferences;

/// In collections above so many models, which are not measured one and all, a query is judged by
/// few: by 500 it took a sixth of a search's time.
constexpr std::size_t kJudgedByAll = 2000;
constexpr std::size_t kMaxJudging = 125;

/// Built-in scale: that of 380 models of 19 classes. It holds until a collection has its own, and
/// weighs as much as this many distances against those.
constexpr ModelScale kTypicalScale = {
    {0.50, 2890.0, 2080.0, 16800.0, 218000.0, 4330.0, 6140.0, 3.6, 0.173, 1.0},
    {0.072, 1050.0, 1000.0, 3430.0, 80000.0, 1490.0, 1500.0, 1.15, 0.040, 1.0}};
static_assert(kTypicalScale.mean.back() > 0.0 && kTypicalScale.deviation.back() > 0.0,
              "a component without a scale");
constexpr double kTypicalWeight = 10.0;
constexpr double kPooledWeight = 4.0;
/// A deviation is at least this share of the mean, for collections of copies.
constexpr double kLeastDeviation = 0.05;

/// Running moments for each component; what is not finite does not count. Nor does pose, which is
/// measured for the models that are ranked by it alone: its scale is the built-in one.
struct ScaleSum {
    ComponentValues sum{};
    ComponentValues square_sum{};
    ComponentValues count{};

    void add(const ComponentValues& distances) {
        for (std::size_t c = 0; c < kComponentCount; ++c) {
            if (c == kPoseComponent || !std::isfinite(distances[c])) continue;
            sum[c] += distances[c];
            square_sum[c] += distances[c] * distances[c];
            count[c] += 1.0;
        }
    }
    void add(const ScaleSum& other) {
        for (std::size_t c = 0; c < kComponentCount; ++c) {
            sum[c] += other.sum[c];
            square_sum[c] += other.square_sum[c];
            count[c] += other.count[c];
        }
    }
    /// The moments with `weight` further distances of the prior's moments among them.
    [[nodiscard]] ModelScale scale(const ModelScale& prior, double weight) const {
        ModelScale scale;
        for (std::size_t c = 0; c < kComponentCount; ++c) {
            const double prior_mean = prior.mean[c], prior_deviation = prior.deviation[c];
            const double total = count[c] + weight;
            const double mean = (sum[c] + weight * prior_mean) / total;
            const double square = (square_sum[c] + weight * (prior_mean * prior_mean +
                                                             prior_deviation * prior_deviation)) /
                                  total;
            scale.mean[c] = mean;
            scale.deviation[c] =
                std::max(std::sqrt(std::max(square - mean * mean, 0.0)), kLeastDeviation * mean);
        }
        return scale;
    }
};

void append(const ModelScale& scale, std::vector<double>& values) {
    values.insert(values.end(), scale.mean.begin(), scale.mean.end());
    values.insert(values.end(), scale.deviation.begin(), scale.deviation.end());
}

/// @pre kScaleSize values from `at` on
ModelScale read_scale(const std::vector<double>& values, std::size_t at) {
    ModelScale scale;
    std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(at), kComponentCount,
                scale.mean.begin());
    std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(at + kComponentCount), kComponentCount,
                scale.deviation.begin());
    return scale;
}

/// The descriptors of some models, without those that are not there any more.
struct Fetched {
    std::vector<std::size_t> indices;  ///< ascending
    std::vector<SharedDescriptor> models;
};

Result<Fetched> fetch(DescriptorSource& collection, std::span<const std::size_t> wanted) {
    const std::vector<std::uint32_t> indices(wanted.begin(), wanted.end());
    auto models = collection.fetch(indices);
    if (!models) return models.error();
    Fetched fetched;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        if (!(*models)[i]) continue;
        fetched.indices.push_back(wanted[i]);
        fetched.models.push_back(std::move((*models)[i]));
    }
    return fetched;
}

/// Sums of the distances of models to the references, themselves left out.
class DistancesToReferences {
public:
    DistancesToReferences(Fetched references, const RankOptions& options)
        : references_(std::move(references)), options_(options), among_(size()) {
        // Reference i measures those after it; the other half of that square is its mirror.
        parallel_for(size(), options_.jobs, [&](std::size_t i) {
            PairMeter meter(options_);
            for (std::size_t j = i + 1; j < size() && !options_.stop.stop_requested(); ++j) {
                among_[i].push_back(
                    meter.components(*references_.models[i], *references_.models[j]));
            }
        });
    }

    [[nodiscard]] ScaleSum of(std::size_t index, const descriptor::ModelDescriptor& model) const {
        ScaleSum sum;
        const auto& indices = references_.indices;
        const auto found = std::lower_bound(indices.begin(), indices.end(), index);
        if (found == indices.end() || *found != index) {
            PairMeter meter(options_);
            for (const SharedDescriptor& reference : references_.models) {
                if (options_.stop.stop_requested()) return sum;
                sum.add(meter.components(model, *reference));
            }
            return sum;
        }
        const auto own = static_cast<std::size_t>(found - indices.begin());
        for (std::size_t other = 0; other < size(); ++other) {
            if (other == own) continue;
            const auto [low, high] = std::minmax(own, other);
            sum.add(among_[low][high - low - 1]);
        }
        return sum;
    }

private:
    [[nodiscard]] std::size_t size() const { return references_.models.size(); }

    const Fetched references_;
    const RankOptions& options_;
    std::vector<std::vector<ComponentValues>> among_;
};

/// What is known of the models that have rows of their own.
struct ModelSums {
    std::vector<std::uint64_t> keys;
    std::vector<ScaleSum> sums;
};

Result<ModelSums> sum_distances(DescriptorSource& collection, std::span<const std::size_t> rows,
                                const DistancesToReferences& distances,
                                const RankOptions& options) {
    constexpr std::size_t kModelsAtOnce = 512;
    ModelSums result;
    for (std::size_t begin = 0; begin < rows.size(); begin += kModelsAtOnce) {
        const auto block =
            fetch(collection, rows.subspan(begin, std::min(kModelsAtOnce, rows.size() - begin)));
        if (!block) return block.error();
        std::vector<ScaleSum> sums(block->models.size());
        parallel_for(sums.size(), options.jobs, [&](std::size_t i) {
            sums[i] = distances.of(block->indices[i], *block->models[i]);
        });
        if (options.stop.stop_requested()) return cancelled();
        for (const SharedDescriptor& model : block->models) {
            result.keys.push_back(model_key(*model));
        }
        result.sums.insert(result.sums.end(), sums.begin(), sums.end());
    }
    return result;
}

}  // namespace

std::uint64_t model_key(const descriptor::ModelDescriptor& model) {
    std::uint64_t hash = 0x9E3779B97F4A7C15ULL ^ model.skeleton.rooted.content_key;
    for (const float value : model.signature) {
        std::uint32_t bits = 0;
        std::memcpy(&bits, &value, sizeof bits);
        hash = (hash ^ bits) * 0x100000001B3ULL;
        hash ^= hash >> 29;
    }
    return hash;
}

std::vector<std::size_t> reference_models(std::size_t count) {
    const std::size_t affordable =
        count > kMaxKnown ? kMaxReferences : kMaxPairs / std::max<std::size_t>(count, 1);
    const std::size_t wanted = std::min(count, std::min(kMaxReferences, affordable));
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < wanted; ++i) indices.push_back(i * count / wanted);
    return indices;
}

std::vector<std::size_t> judging_models(std::size_t count) {
    std::vector<std::size_t> indices = reference_models(count);
    if (count <= kJudgedByAll) return indices;
    const std::size_t step = (indices.size() + kMaxJudging - 1) / kMaxJudging;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < indices.size(); i += step) indices[kept++] = indices[i];
    indices.resize(kept);
    return indices;
}

Normalization::Normalization(const CollectionStatistics& statistics) : pooled_(kTypicalScale) {
    const std::vector<double>& values = statistics.values;
    if (values.size() < kHeader || values[0] != kFormat ||
        values[1] != static_cast<double>(kComponentCount) ||
        (values.size() - kHeader) % kRecord != 0) {
        return;
    }
    collection_size_ = static_cast<std::size_t>(std::max(values[2], 0.0));
    pooled_ = read_scale(values, 3);
    known_.reserve((values.size() - kHeader) / kRecord);
    for (std::size_t at = kHeader; at < values.size(); at += kRecord) {
        const std::uint64_t key = (static_cast<std::uint64_t>(values[at]) << 32) |
                                  static_cast<std::uint64_t>(values[at + 1]);
        known_.emplace(key, read_scale(values, at + 2));
    }
}

const ModelScale* Normalization::find(const descriptor::ModelDescriptor& model) const {
    return known_.empty() ? nullptr : find(model_key(model));
}

const ModelScale* Normalization::find(std::uint64_t key) const {
    const auto found = known_.find(key);
    return found != known_.end() ? &found->second : nullptr;
}

ModelScale scale_of_row(const std::vector<ComponentValues>& distances, const ModelScale& pooled) {
    ScaleSum sum;
    for (const ComponentValues& values : distances) sum.add(values);
    return sum.scale(pooled, kPooledWeight);
}

Result<CollectionStatistics> collection_statistics(DescriptorSpan collection, int jobs,
                                                   const std::stop_token& stop) {
    DescriptorsInMemory source(collection);
    return collection_statistics(source, jobs, stop);
}

Result<CollectionStatistics> collection_statistics(DescriptorSource& collection, int jobs,
                                                   const std::stop_token& stop) {
    const std::vector<std::size_t> references = reference_models(collection.size());
    std::vector<std::size_t> rows = references;
    const bool all_known = collection.size() <= kMaxKnown;
    if (all_known) {
        rows.resize(collection.size());
        for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = i;
    }
    RankOptions options;
    options.jobs = jobs;
    options.stop = stop;
    auto fetched = fetch(collection, references);
    if (!fetched) return fetched.error();
    const DistancesToReferences distances(*std::move(fetched), options);
    // Else some of what the sums are of is missing.
    if (stop.stop_requested()) return cancelled();
    const auto models = sum_distances(collection, rows, distances, options);
    if (!models) return models.error();
    if (stop.stop_requested()) return cancelled();

    ScaleSum all;
    for (const ScaleSum& sum : models->sums) all.add(sum);
    const ModelScale pooled = all.scale(kTypicalScale, kTypicalWeight);

    CollectionStatistics statistics;
    std::vector<double>& values = statistics.values;
    values = {kFormat, static_cast<double>(kComponentCount),
              static_cast<double>(collection.size())};
    append(pooled, values);
    if (!all_known) return statistics;
    for (std::size_t row = 0; row < models->sums.size(); ++row) {
        const std::uint64_t key = models->keys[row];
        values.push_back(static_cast<double>(key >> 32));
        values.push_back(static_cast<double>(key & 0xFFFFFFFFULL));
        append(models->sums[row].scale(pooled, kPooledWeight), values);
    }
    return statistics;
}

}  // namespace ossuary::ranking
