#include "engine/ranking/ranker.h"

#include <algorithm>
#include <cassert>
#include <string>

#include "engine/core/parallel.h"
#include "engine/ranking/cancelled.h"
#include "engine/ranking/each_with_meter.h"
#include "engine/ranking/fusion.h"
#include "engine/ranking/normalization.h"
#include "engine/ranking/pair_distances.h"
#include "engine/ranking/part_search.h"
#include "engine/ranking/rerank.h"

namespace ossuary::ranking {
namespace {

std::vector<FusionSide> fusion_sides(DescriptorSpan collection, const Normalization& normalization,
                                     const RankOptions& options) {
    std::vector<FusionSide> sides(collection.size());
    if (options.ranker == RankerKind::kChainCode) return sides;
    parallel_for(collection.size(), options.jobs, [&](std::size_t i) {
        if (options.stop.stop_requested()) return;
        const ModelScale& scale = normalization.scale(*collection[i]);
        sides[i] = fusion_side(*collection[i], scale, options);
    });
    return sides;
}

/// The side of a query: known to the statistics, or to be judged by its own row.
FusionSide query_side(const descriptor::ModelDescriptor& query,
                      const std::vector<ComponentValues>& row, const Normalization& normalization,
                      const RankOptions& options) {
    if (const ModelScale* own = normalization.find(query)) {
        return fusion_side(query, *own, options);
    }
    // A handful of finalists says nothing of the collection.
    if (2 * row.size() < normalization.collection_size()) {
        return fusion_side(query, normalization.pooled(), options);
    }
    std::vector<ComponentValues> references;
    for (const std::size_t i : judging_models(row.size())) references.push_back(row[i]);
    return fusion_side(query, scale_of_row(references, normalization.pooled()), options);
}

std::vector<double> row_distances(const descriptor::ModelDescriptor& query,
                                  DescriptorSpan collection, const Normalization& normalization,
                                  const std::vector<FusionSide>& sides,
                                  const RankOptions& options) {
    std::vector<double> distances(collection.size());
    if (options.ranker == RankerKind::kChainCode) {
        for_each_with_meter(collection.size(), options, [&](PairMeter& meter, std::size_t j) {
            distances[j] = meter.chain_code(query, *collection[j]);
        });
        return distances;
    }
    std::vector<ComponentValues> row(collection.size());
    for_each_with_meter(collection.size(), options, [&](PairMeter& meter, std::size_t j) {
        row[j] = meter.components(query, *collection[j]);
    });
    const FusionSide side = query_side(query, row, normalization, options);
    for (std::size_t j = 0; j < row.size(); ++j) {
        distances[j] = fused_distance(row[j], side, sides[j]);
    }
    return distances;
}

/// Distances among the collection's own models, each model with the side that the statistics give.
double collection_distance(PairMeter& meter, DescriptorSpan collection,
                           const std::vector<FusionSide>& sides, RankerKind ranker, std::size_t i,
                           std::size_t j) {
    if (ranker == RankerKind::kChainCode) return meter.chain_code(*collection[i], *collection[j]);
    return fused_distance(meter.components(*collection[i], *collection[j]), sides[i], sides[j]);
}

/// Models that the statistics do not know are judged by their own row as queries, so that their
/// rows are not the mirror of their columns.
bool all_known(DescriptorSpan collection, const Normalization& normalization) {
    return std::all_of(collection.begin(), collection.end(),
                       [&](const descriptor::ModelDescriptor* model) {
                           return normalization.find(*model) != nullptr;
                       });
}

/// The full matrix in double precision, each pair measured once.
std::vector<double> mirrored_matrix(DescriptorSpan collection, const std::vector<FusionSide>& sides,
                                    const RankOptions& options) {
    const std::size_t n = collection.size();
    std::vector<double> matrix(n * n, 0.0);
    parallel_for(n, options.jobs, [&](std::size_t i) {
        PairMeter meter(options);
        for (std::size_t j = i; j < n && !options.stop.stop_requested(); ++j) {
            const double d = collection_distance(meter, collection, sides, options.ranker, i, j);
            matrix[i * n + j] = d;
            matrix[j * n + i] = d;
        }
    });
    return matrix;
}

}  // namespace

std::string_view to_string(RankerKind ranker) {
    switch (ranker) {
        case RankerKind::kHybrid:
            return "hybrid";
        case RankerKind::kSkeleton:
            return "skeleton";
        case RankerKind::kChainCode:
            return "chain-code";
    }
    assert(false);
    return "";
}

Result<RankerKind> parse_ranker(std::string_view name) {
    for (const RankerKind ranker : kAllRankers) {
        if (name == to_string(ranker)) return ranker;
    }
    return {ErrorCode::kInvalidArgument,
            "ranker '" + std::string(name) + "'; expected hybrid, skeleton or chain-code"};
}

Result<std::vector<double>> rank_distances(const descriptor::ModelDescriptor& query,
                                           DescriptorSpan collection,
                                           const CollectionStatistics& statistics,
                                           const RankOptions& options) {
    assert(!(options.part && options.rerank));
    if (options.part) return part_distances(query, collection, options);
    const Normalization normalization(statistics);
    const std::vector<FusionSide> sides = fusion_sides(collection, normalization, options);
    std::vector<double> distances = row_distances(query, collection, normalization, sides, options);
    if (options.rerank) {
        const auto among = [&](std::size_t i, std::span<const std::size_t> others) {
            PairMeter meter(options);
            std::vector<double> row(others.size());
            for (std::size_t k = 0; k < others.size() && !options.stop.stop_requested(); ++k) {
                row[k] =
                    collection_distance(meter, collection, sides, options.ranker, i, others[k]);
            }
            return row;
        };
        distances = rerank(distances, among, {}, options.jobs);
    }
    if (options.stop.stop_requested()) return cancelled();
    return distances;
}

Result<DistanceMatrix> distance_matrix(DescriptorSpan collection,
                                       const CollectionStatistics& statistics,
                                       const RankOptions& options) {
    assert(!options.part);
    const std::size_t n = collection.size();
    DistanceMatrix matrix;
    matrix.size = n;
    matrix.values.resize(n * n);
    const auto set_row = [&](std::size_t i, const std::vector<double>& row) {
        for (std::size_t j = 0; j < n; ++j) matrix.values[i * n + j] = static_cast<float>(row[j]);
    };

    const Normalization normalization(statistics);
    if (options.ranker != RankerKind::kChainCode && !all_known(collection, normalization)) {
        for (std::size_t i = 0; i < n; ++i) {
            const auto row = rank_distances(*collection[i], collection, statistics, options);
            if (!row) return row.error();
            set_row(i, *row);
        }
        return matrix;
    }
    const std::vector<FusionSide> sides = fusion_sides(collection, normalization, options);
    const std::vector<double> full = mirrored_matrix(collection, sides, options);
    const auto among = [&](std::size_t i, std::span<const std::size_t> others) {
        std::vector<double> row;
        row.reserve(others.size());
        for (const std::size_t j : others) row.push_back(full[i * n + j]);
        return row;
    };
    parallel_for(n, options.jobs, [&](std::size_t i) {
        if (options.stop.stop_requested()) return;
        const auto begin = full.begin() + static_cast<std::ptrdiff_t>(i * n);
        std::vector<double> row(begin, begin + static_cast<std::ptrdiff_t>(n));
        set_row(i, options.rerank ? rerank(row, among) : row);
    });
    if (options.stop.stop_requested()) return cancelled();
    return matrix;
}

}  // namespace ossuary::ranking
