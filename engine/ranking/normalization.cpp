#include "engine/ranking/normalization.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "engine/core/parallel.h"

namespace ossuary {
namespace {

constexpr double kFormat = 1.0;
constexpr std::size_t kHeader = 3 + kComponentCount;
constexpr std::size_t kRecord = 2 + kComponentCount;
/// Distances are taken to at most this many models.
constexpr std::size_t kMaxReferences = 500;
/// Collections up to this size know the scale of every model, larger ones of the references only.
constexpr std::size_t kMaxKnown = 2000;
/// Built-in scales: mean distances over a mixed collection. They hold until a collection has its
/// own, and weigh as much as this many distances against those.
constexpr ModelScale kTypicalScale = {0.35, 1.0, 0.5, 0.1, 0.1, 0.6};
constexpr double kTypicalWeight = 10.0;
constexpr double kPooledWeight = 4.0;

/// Identifies a descriptor by its signature, which every part of it has a share in.
std::uint64_t model_key(const ModelDescriptor& model) {
    std::uint64_t hash = 0x9E3779B97F4A7C15ULL ^ model.skeleton.rooted.content_key;
    for (const float value : model.signature) {
        std::uint32_t bits = 0;
        std::memcpy(&bits, &value, sizeof bits);
        hash = (hash ^ bits) * 0x100000001B3ULL;
        hash ^= hash >> 29;
    }
    return hash;
}

/// A running mean for each component; what is not finite does not count.
struct ScaleSum {
    ComponentValues sum{};
    ComponentValues count{};

    void add(const ComponentValues& distances) {
        for (std::size_t c = 0; c < kComponentCount; ++c) {
            if (!std::isfinite(distances[c])) continue;
            sum[c] += distances[c];
            count[c] += 1.0;
        }
    }
    [[nodiscard]] ModelScale mean(const ModelScale& prior, double prior_weight) const {
        ModelScale scale{};
        for (std::size_t c = 0; c < kComponentCount; ++c) {
            scale[c] = (sum[c] + prior_weight * prior[c]) / (count[c] + prior_weight);
        }
        return scale;
    }
};

/// Indices of the reference models: all, or evenly spread over the collection.
std::vector<std::size_t> reference_models(std::size_t count) {
    const std::size_t wanted = std::min(count, kMaxReferences);
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < wanted; ++i) indices.push_back(i * count / wanted);
    return indices;
}

/// For each model of `rows` the sum of its distances to the references, itself left out.
std::vector<ScaleSum> sum_distances(DescriptorSpan collection, const std::vector<std::size_t>& rows,
                                    const std::vector<std::size_t>& references, int jobs) {
    // Reference i measures the references after it; the other half of that square is its mirror.
    std::vector<std::vector<ComponentValues>> among(references.size());
    parallel_for(references.size(), jobs, [&](std::size_t i) {
        PairMeter meter{RankOptions{}};
        for (std::size_t j = i + 1; j < references.size(); ++j) {
            among[i].push_back(
                meter.components(*collection[references[i]], *collection[references[j]]));
        }
    });
    std::vector<ScaleSum> sums(rows.size());
    parallel_for(rows.size(), jobs, [&](std::size_t row) {
        const auto found = std::lower_bound(references.begin(), references.end(), rows[row]);
        if (found == references.end() || *found != rows[row]) {
            PairMeter meter{RankOptions{}};
            for (const std::size_t reference : references) {
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

Normalization::Normalization(const CollectionStatistics& statistics) : pooled_(kTypicalScale) {
    const std::vector<double>& values = statistics.values;
    if (values.size() < kHeader || values[0] != kFormat ||
        values[1] != static_cast<double>(kComponentCount) ||
        (values.size() - kHeader) % kRecord != 0) {
        return;
    }
    collection_size_ = static_cast<std::size_t>(std::max(values[2], 0.0));
    std::copy_n(values.begin() + 3, kComponentCount, pooled_.begin());
    known_.reserve((values.size() - kHeader) / kRecord);
    for (std::size_t at = kHeader; at < values.size(); at += kRecord) {
        const std::uint64_t key = (static_cast<std::uint64_t>(values[at]) << 32) |
                                  static_cast<std::uint64_t>(values[at + 1]);
        ModelScale scale{};
        std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(at + 2), kComponentCount,
                    scale.begin());
        known_.emplace(key, scale);
    }
}

const ModelScale* Normalization::find(const ModelDescriptor& model) const {
    if (known_.empty()) return nullptr;
    const auto found = known_.find(model_key(model));
    return found != known_.end() ? &found->second : nullptr;
}

ModelScale scale_of_row(const std::vector<ComponentValues>& distances, const ModelScale& pooled) {
    ScaleSum sum;
    for (const ComponentValues& values : distances) sum.add(values);
    return sum.mean(pooled, kPooledWeight);
}

CollectionStatistics collection_statistics(DescriptorSpan collection, int jobs) {
    const std::vector<std::size_t> references = reference_models(collection.size());
    std::vector<std::size_t> rows = references;
    if (collection.size() <= kMaxKnown) {
        rows.resize(collection.size());
        for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = i;
    }
    const std::vector<ScaleSum> sums = sum_distances(collection, rows, references, jobs);

    ScaleSum all;
    for (const ScaleSum& sum : sums) {
        for (std::size_t c = 0; c < kComponentCount; ++c) {
            all.sum[c] += sum.sum[c];
            all.count[c] += sum.count[c];
        }
    }
    const ModelScale pooled = all.mean(kTypicalScale, kTypicalWeight);

    CollectionStatistics statistics;
    std::vector<double>& values = statistics.values;
    values = {kFormat, static_cast<double>(kComponentCount),
              static_cast<double>(collection.size())};
    values.insert(values.end(), pooled.begin(), pooled.end());
    for (std::size_t row = 0; row < rows.size(); ++row) {
        const std::uint64_t key = model_key(*collection[rows[row]]);
        values.push_back(static_cast<double>(key >> 32));
        values.push_back(static_cast<double>(key & 0xFFFFFFFFULL));
        const ModelScale scale = sums[row].mean(pooled, kPooledWeight);
        values.insert(values.end(), scale.begin(), scale.end());
    }
    return statistics;
}

}  // namespace ossuary
