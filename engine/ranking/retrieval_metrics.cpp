#include "engine/ranking/retrieval_metrics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <unordered_map>
#include <utility>

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
std::vector<std::uint32_t> ranked_list(std::span<const float> distances, std::size_t query) {
    std::vector<std::uint32_t> list;
    list.reserve(distances.size());
    for (std::size_t j = 0; j < distances.size(); ++j) {
        if (j != query) list.push_back(static_cast<std::uint32_t>(j));
    }
    const auto key = [&](std::uint32_t j) {
        const float d = distances[j];
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

/// Adds up a report, query by query.
class ReportSum {
public:
    ReportSum(std::span<const std::string> labels, const RetrievalOptions& options)
        : classes_(number_classes(labels)),
          reported_(classes_.names.size(), kNoClass),
          least_(std::max<std::size_t>(options.min_class_size, 2)) {}

    /// Whether a model is of a class that is large enough.
    [[nodiscard]] bool is_query(std::size_t model) const {
        const std::size_t own = classes_.class_of_model[model];
        return own != kNoClass && classes_.sizes[own] >= least_;
    }

    /// Reports on the classes of these queries, in order of their first appearance in the
    /// collection.
    void expect(std::span<const std::size_t> queries) {
        std::vector<bool> asked(classes_.names.size(), false);
        for (const std::size_t query : queries) asked[classes_.class_of_model[query]] = true;
        for (std::size_t c = 0; c < asked.size(); ++c) {
            if (!asked[c]) continue;
            reported_[c] = report_.classes++;
            report_.per_class.push_back({classes_.names[c], classes_.sizes[c], {}});
        }
        report_.confusion.assign(report_.classes * report_.classes, 0.0);
        queries_of_.assign(report_.classes, 0);
    }

    void add_query(std::size_t query, std::span<const float> distances) {
        const std::size_t own = classes_.class_of_model[query];
        const std::vector<std::uint32_t> list = ranked_list(distances, query);
        const std::vector<std::size_t> ranks = relevant_ranks(list, classes_, own);
        const RetrievalMetrics metrics = query_metrics(ranks, list.size());

        const std::size_t row = reported_[own];
        ++queries_of_[row];
        add(report_.per_class[row].metrics, metrics);
        add(report_.mean, metrics);
        curve_.add(ranks);
        report_.per_query.push_back({query, metrics});

        const std::size_t nearest = classes_.class_of_model[list.front()];
        if (nearest != kNoClass && reported_[nearest] != kNoClass) {
            report_.confusion[row * report_.classes + reported_[nearest]] += 1.0;
        }
    }

    RetrievalReport report() && {
        report_.models = report_.per_query.size();
        report_.precision_recall = curve_.mean();
        for (std::size_t i = 0; i < report_.classes; ++i) {
            ClassMetrics& entry = report_.per_class[i];
            divide(entry.metrics, queries_of_[i]);
            add(report_.macro_mean, entry.metrics);
            for (std::size_t j = 0; j < report_.classes; ++j) {
                report_.confusion[i * report_.classes + j] /= static_cast<double>(queries_of_[i]);
            }
        }
        if (report_.models > 0) {
            divide(report_.mean, report_.models);
            divide(report_.macro_mean, report_.classes);
        }
        return std::move(report_);
    }

private:
    const ClassTable classes_;
    std::vector<std::size_t> reported_;  ///< row of each class; kNoClass where it has none
    const std::size_t least_;
    std::vector<std::size_t> queries_of_;  ///< by row
    PrecisionRecallSum curve_;
    RetrievalReport report_;
};

}  // namespace

std::vector<std::size_t> retrieval_queries(std::span<const std::string> labels,
                                           const RetrievalOptions& options) {
    const ReportSum sum(labels, options);
    std::vector<std::size_t> queries;
    for (std::size_t model = 0; model < labels.size(); ++model) {
        if (sum.is_query(model)) queries.push_back(model);
    }
    return queries;
}

RetrievalReport evaluate_retrieval(const DistanceMatrix& distances,
                                   std::span<const std::string> labels,
                                   const RetrievalOptions& options) {
    assert(labels.size() == distances.size);
    assert(distances.values.size() == distances.size * distances.size);
    const std::vector<std::size_t> queries = retrieval_queries(labels, options);
    ReportSum sum(labels, options);
    sum.expect(queries);
    const std::span<const float> values(distances.values);
    for (const std::size_t query : queries) {
        sum.add_query(query, values.subspan(query * distances.size, distances.size));
    }
    return std::move(sum).report();
}

RetrievalReport evaluate_queries(std::span<const QueryDistances> queries,
                                 std::span<const std::string> labels,
                                 const RetrievalOptions& options) {
    ReportSum sum(labels, options);
    std::vector<std::size_t> asked;
    for (const QueryDistances& each : queries) {
        assert(each.distances.size() == labels.size());
        assert(sum.is_query(each.query));
        asked.push_back(each.query);
    }
    sum.expect(asked);
    for (const QueryDistances& each : queries) sum.add_query(each.query, each.distances);
    return std::move(sum).report();
}

}  // namespace ossuary::ranking
