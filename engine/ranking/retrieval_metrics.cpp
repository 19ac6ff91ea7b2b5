#include "engine/ranking/retrieval_metrics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <unordered_map>

namespace ossuary::ranking {
namespace {

constexpr std::size_t kRecallLevels = 20;
constexpr std::size_t kPageLength = 32;  // of the E-measure
constexpr std::size_t kNoClass = std::numeric_limits<std::size_t>::max();

/// The classes by number, in order of first appearance.
struct ClassTable {
    std::vector<std::string> names;
    std::vector<std::size_t> sizes;
    std::vector<std::size_t> class_of_model;  // kNoClass for none
};

ClassTable number_classes(std::span<const std::string> labels) {
    ClassTable table;
    std::unordered_map<std::string, std::size_t> number_of;
    for (const std::string& label : labels) {
        if (label.empty() || label == "-1") {
            table.class_of_model.push_back(kNoClass);
            continue;
        }
        const auto [entry, is_new] = number_of.try_emplace(label, table.names.size());
        if (is_new) {
            table.names.push_back(label);
            table.sizes.push_back(0);
        }
        ++table.sizes[entry->second];
        table.class_of_model.push_back(entry->second);
    }
    return table;
}

/// All models but the query, nearest first.
std::vector<std::uint32_t> ranked_list(const DistanceMatrix& distances, std::size_t query) {
    std::vector<std::uint32_t> list;
    list.reserve(distances.size);
    for (std::size_t j = 0; j < distances.size; ++j) {
        if (j != query) list.push_back(static_cast<std::uint32_t>(j));
    }
    const auto key = [&](std::uint32_t j) {
        const float d = distances.at(query, j);
        return std::isnan(d) ? std::numeric_limits<float>::infinity() : d;
    };
    std::sort(list.begin(), list.end(), [&](std::uint32_t a, std::uint32_t b) {
        const float da = key(a), db = key(b);
        return da != db ? da < db : a < b;
    });
    return list;
}

/// 1-based ranks of the models of the query's class, ascending.
std::vector<std::size_t> relevant_ranks(const std::vector<std::uint32_t>& list,
                                        const ClassTable& classes, std::size_t query_class) {
    std::vector<std::size_t> ranks;
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (classes.class_of_model[list[i]] == query_class) ranks.push_back(i + 1);
    }
    return ranks;
}

double gain(std::size_t rank) {
    return rank == 1 ? 1.0 : 1.0 / std::log2(static_cast<double>(rank));
}

RetrievalMetrics query_metrics(const std::vector<std::size_t>& ranks, std::size_t list_length) {
    const std::size_t relevant = ranks.size();
    const auto within = [&](std::size_t length) {
        return static_cast<double>(std::upper_bound(ranks.begin(), ranks.end(), length) -
                                   ranks.begin());
    };
    const double count = static_cast<double>(relevant);
    RetrievalMetrics metrics;
    metrics.nearest_neighbor = ranks.front() == 1 ? 1.0 : 0.0;
    metrics.first_tier = within(relevant) / count;
    metrics.second_tier = within(2 * relevant) / count;

    const std::size_t page = std::min(kPageLength, list_length);
    // 2 / (1/P + 1/R) with P = h / page and R = h / relevant.
    metrics.e_measure = 2.0 * within(page) / (static_cast<double>(page) + count);

    double total = 0.0, best = 0.0, precision_sum = 0.0;
    for (std::size_t i = 0; i < relevant; ++i) {
        total += gain(ranks[i]);
        best += gain(i + 1);
        precision_sum += static_cast<double>(i + 1) / static_cast<double>(ranks[i]);
    }
    metrics.dcg = total / best;
    metrics.mean_average_precision = precision_sum / count;
    return metrics;
}

/// The sum of precisions at each recall level and the number of queries that reach it.
struct PrecisionRecallSum {
    std::vector<double> precision = std::vector<double>(kRecallLevels, 0.0);
    std::vector<std::size_t> queries = std::vector<std::size_t>(kRecallLevels, 0);

    void add(const std::vector<std::size_t>& ranks) {
        const std::size_t relevant = ranks.size();
        const auto precision_at = [&](std::size_t i) {
            return static_cast<double>(i + 1) / static_cast<double>(ranks[i]);
        };
        for (std::size_t level = 0; level < kRecallLevels; ++level) {
            // Recall (level + 1) / 20 lies at position (level + 1) * relevant / 20 - 1 of the list
            // of precisions; whole numbers keep it exact.
            const std::size_t scaled = (level + 1) * relevant;
            if (scaled < kRecallLevels) continue;
            const std::size_t lower = scaled / kRecallLevels - 1;
            const std::size_t upper = std::min(lower + 1, relevant - 1);
            const double share =
                static_cast<double>(scaled % kRecallLevels) / static_cast<double>(kRecallLevels);
            precision[level] += (1.0 - share) * precision_at(lower) + share * precision_at(upper);
            ++queries[level];
        }
    }

    [[nodiscard]] std::vector<PrecisionRecallPoint> mean() const {
        std::vector<PrecisionRecallPoint> points(kRecallLevels);
        double known = 0.0;
        for (std::size_t level = kRecallLevels; level-- > 0;) {
            if (queries[level] > 0) known = precision[level] / static_cast<double>(queries[level]);
            points[level] = {static_cast<double>(level + 1) / static_cast<double>(kRecallLevels),
                             known};
        }
        return points;
    }
};

constexpr double RetrievalMetrics::*kFields[] = {&RetrievalMetrics::nearest_neighbor,
                                                 &RetrievalMetrics::first_tier,
                                                 &RetrievalMetrics::second_tier,
                                                 &RetrievalMetrics::e_measure,
                                                 &RetrievalMetrics::dcg,
                                                 &RetrievalMetrics::mean_average_precision};

void add(RetrievalMetrics& sum, const RetrievalMetrics& term) {
    for (const auto field : kFields) sum.*field += term.*field;
}

void divide(RetrievalMetrics& sum, std::size_t count) {
    for (const auto field : kFields) sum.*field /= static_cast<double>(count);
}

}  // namespace

RetrievalReport evaluate_retrieval(const DistanceMatrix& distances,
                                   std::span<const std::string> labels,
                                   const RetrievalOptions& options) {
    assert(labels.size() == distances.size);
    assert(distances.values.size() == distances.size * distances.size);
    const ClassTable classes = number_classes(labels);

    RetrievalReport report;
    std::vector<std::size_t> reported(classes.names.size(), kNoClass);
    for (std::size_t c = 0; c < classes.names.size(); ++c) {
        if (classes.sizes[c] < std::max<std::size_t>(options.min_class_size, 2)) continue;
        reported[c] = report.classes++;
        report.per_class.push_back({classes.names[c], classes.sizes[c], {}});
    }
    report.confusion.assign(report.classes * report.classes, 0.0);

    PrecisionRecallSum curve;
    for (std::size_t query = 0; query < distances.size; ++query) {
        const std::size_t own = classes.class_of_model[query];
        if (own == kNoClass || reported[own] == kNoClass) continue;
        const std::vector<std::uint32_t> list = ranked_list(distances, query);
        const std::vector<std::size_t> ranks = relevant_ranks(list, classes, own);
        const RetrievalMetrics metrics = query_metrics(ranks, list.size());

        ClassMetrics& class_metrics = report.per_class[reported[own]];
        add(class_metrics.metrics, metrics);
        add(report.mean, metrics);
        curve.add(ranks);
        report.per_query.push_back({query, metrics});

        const std::size_t nearest = classes.class_of_model[list.front()];
        if (nearest != kNoClass && reported[nearest] != kNoClass) {
            report.confusion[reported[own] * report.classes + reported[nearest]] += 1.0;
        }
    }

    report.models = report.per_query.size();
    report.precision_recall = curve.mean();
    for (std::size_t i = 0; i < report.classes; ++i) {
        ClassMetrics& entry = report.per_class[i];
        divide(entry.metrics, entry.models);
        add(report.macro_mean, entry.metrics);
        for (std::size_t j = 0; j < report.classes; ++j) {
            report.confusion[i * report.classes + j] /= static_cast<double>(entry.models);
        }
    }
    if (report.models > 0) {
        divide(report.mean, report.models);
        divide(report.macro_mean, report.classes);
    }
    return report;
}

}  // namespace ossuary::ranking
