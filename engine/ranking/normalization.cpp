#include "engine/ranking/normalization.h"

#include <algorithm>
#include <cmath>
#include <cstring>

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

/// Identifies a descriptor by its signature, which every part of it has a share in.
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

/// For each model of `rows` the sum of its distances to the references, itself left out.
std::vector<ScaleSum> sum_distances(DescriptorSpan collection, const std::vector<std::size_t>& rows,
                                    const std::vector<std::size_t>& references,
                                    const RankOptions& options) {
    // Reference i measures the references after it; the other half of that square is its mirror.
    std::vector<std::vector<ComponentValues>> among(references.size());
    parallel_for(references.size(), options.jobs, [&](std::size_t i) {
        PairMeter meter(options);
        for (std::size_t j = i + 1; j < references.size() && !options.stop.stop_requested(); ++j) {
            among[i].push_back(
                meter.components(*collection[references[i]], *collection[references[j]]));
        }
    });
    if (options.stop.stop_requested()) return {};
    std::vector<ScaleSum> sums(rows.size());
    parallel_for(rows.size(), options.jobs, [&](std::size_t row) {
        const auto found = std::lower_bound(references.begin(), references.end(), rows[row]);
        if (found == references.end() || *found != rows[row]) {
            PairMeter meter(options);
            for (const std::size_t reference : references) {
                if (options.stop.stop_requested()) return;
                sums[row].add(meter.components(*collection[rows[row]], *collection[reference]));
            }
            return;
        }
        const auto own = static_cast<std::size_t>(found - references.begin());
        for (std::size_t other = 0; other < references.size(); ++other) {
            if (other == own) continue;
            const auto [low, high] = std::minmax(own, other);
            sums[row].add(among[low][high - low - 1]);
        }
    });
    return sums;
}

}  // namespace

std::vector<std::size_t> reference_models(std::size_t count) {
    const std::size_t affordable =
        count > kMaxKnown ? kMaxReferences : kMaxPairs / std::max<std::size_t>(count, 1);
    const std::size_t wanted = std::min(count, std::min(kMaxReferences, affordable));
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < wanted; ++i) indices.push_back(i * count / wanted);
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
    if (known_.empty()) return nullptr;
    const auto found = known_.find(model_key(model));
    return found != known_.end() ? &found->second : nullptr;
}

ModelScale scale_of_row(const std::vector<ComponentValues>& distances, const ModelScale& pooled) {
    ScaleSum sum;
    for (const ComponentValues& values : distances) sum.add(values);
    return sum.scale(pooled, kPooledWeight);
}

Result<CollectionStatistics> collection_statistics(DescriptorSpan collection, int jobs,
                                                   const std::stop_token& stop) {
    const std::vector<std::size_t> references = reference_models(collection.size());
    std::vector<std::size_t> rows = references;
    if (collection.size() <= kMaxKnown) {
        rows.resize(collection.size());
        for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = i;
    }
    RankOptions options;
    options.jobs = jobs;
    options.stop = stop;
    const std::vector<ScaleSum> sums = sum_distances(collection, rows, references, options);
    if (stop.stop_requested()) return cancelled();

    ScaleSum all;
    for (const ScaleSum& sum : sums) all.add(sum);
    const ModelScale pooled = all.scale(kTypicalScale, kTypicalWeight);

    CollectionStatistics statistics;
    std::vector<double>& values = statistics.values;
    values = {kFormat, static_cast<double>(kComponentCount),
              static_cast<double>(collection.size())};
    append(pooled, values);
    if (rows.size() != collection.size()) return statistics;
    for (std::size_t row = 0; row < rows.size(); ++row) {
        const std::uint64_t key = model_key(*collection[rows[row]]);
        values.push_back(static_cast<double>(key >> 32));
        values.push_back(static_cast<double>(key & 0xFFFFFFFFULL));
        append(sums[row].scale(pooled, kPooledWeight), values);
    }
    return statistics;
}

}  // namespace ossuary::ranking
