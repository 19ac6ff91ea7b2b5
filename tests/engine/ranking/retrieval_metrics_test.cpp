#include "engine/ranking/retrieval_metrics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace ossuary::ranking {
namespace {

DistanceMatrix matrix_of(std::vector<std::vector<float>> rows) {
    DistanceMatrix matrix;
    matrix.size = rows.size();
    for (const auto& row : rows) {
        matrix.values.insert(matrix.values.end(), row.begin(), row.end());
    }
    return matrix;
}

/// 1 / log2(3), to 12 digits, so that the expected values below are worked out by hand.
constexpr double kGainAt3 = 0.630929753571;

// Five models: 0, 1, 2 of class a, 3 of class b with 4.
//   query 0: 1a 3b 2a 4b   ranks of a: 1, 3
//   query 1: 3b 4b 0a 2a   ranks of a: 3, 4
//   query 2: 0a 1a 3b 4b   ranks of a: 1, 2
//   query 3: 0a 1a 2a 4b   rank of b: 4
//   query 4: 3b 0a 1a 2a   rank of b: 1
DistanceMatrix small_matrix() {
    return matrix_of({{0.0F, 0.1F, 0.3F, 0.2F, 0.4F},
                      {0.3F, 0.0F, 0.4F, 0.1F, 0.2F},
                      {0.1F, 0.2F, 0.0F, 0.3F, 0.4F},
                      {0.1F, 0.2F, 0.3F, 0.0F, 0.4F},
                      {0.2F, 0.3F, 0.4F, 0.1F, 0.0F}});
}
const std::vector<std::string> kSmallLabels = {"a", "a", "a", "b", "b"};

std::vector<QueryDistances> rows_of(const DistanceMatrix& matrix,
                                    const std::vector<std::size_t>& queries) {
    std::vector<QueryDistances> rows;
    for (const std::size_t query : queries) {
        QueryDistances row{query, {}};
        for (std::size_t j = 0; j < matrix.size; ++j) row.distances.push_back(matrix.at(query, j));
        rows.push_back(std::move(row));
    }
    return rows;
}

TEST(RetrievalMetrics, AreTheSameRowByRow) {
    const std::vector<std::size_t> queries = retrieval_queries(kSmallLabels);
    EXPECT_EQ(queries, (std::vector<std::size_t>{0, 1, 2, 3, 4}));
    const RetrievalReport whole = evaluate_retrieval(small_matrix(), kSmallLabels);
    const RetrievalReport rows = evaluate_queries(rows_of(small_matrix(), queries), kSmallLabels);
    EXPECT_EQ(rows.models, whole.models);
    EXPECT_EQ(rows.mean.dcg, whole.mean.dcg);
    EXPECT_EQ(rows.macro_mean.mean_average_precision, whole.macro_mean.mean_average_precision);
    EXPECT_EQ(rows.confusion, whole.confusion);
}

TEST(RetrievalMetrics, OfSomeQueriesAreTheMeansOfThese) {
    const RetrievalReport whole = evaluate_retrieval(small_matrix(), kSmallLabels);
    const RetrievalReport some = evaluate_queries(rows_of(small_matrix(), {0, 1}), kSmallLabels);
    EXPECT_EQ(some.models, 2U);
    ASSERT_EQ(some.classes, 1U);
    EXPECT_EQ(some.per_class[0].name, "a");
    EXPECT_EQ(some.per_class[0].models, 3U);
    const auto of = [&](std::size_t query) {
        return whole.per_query[query].metrics.mean_average_precision;
    };
    EXPECT_DOUBLE_EQ(some.mean.mean_average_precision, (of(0) + of(1)) / 2.0);
    EXPECT_DOUBLE_EQ(some.per_class[0].metrics.mean_average_precision, (of(0) + of(1)) / 2.0);
    EXPECT_EQ(evaluate_queries({}, kSmallLabels).models, 0U);
}

TEST(RetrievalMetrics, AgreeWithACaseWorkedOutByHand) {
    const RetrievalReport report = evaluate_retrieval(small_matrix(), kSmallLabels);
    ASSERT_EQ(report.models, 5U);
    ASSERT_EQ(report.classes, 2U);
    ASSERT_EQ(report.per_query.size(), 5U);

    // Query 0: |C| - 1 = 2 others. First two results hold one of them, first four hold both. The
    // page is the whole list of 4: P = 2/4, R = 1, E = 2 / (2 + 1). Gains 1 + 1/log2(3) of 1 + 1.
    // Precision 1/1 and 2/3.
    const RetrievalMetrics& first = report.per_query[0].metrics;
    EXPECT_DOUBLE_EQ(first.nearest_neighbor, 1.0);
    EXPECT_DOUBLE_EQ(first.first_tier, 0.5);
    EXPECT_DOUBLE_EQ(first.second_tier, 1.0);
    EXPECT_DOUBLE_EQ(first.e_measure, 2.0 / 3.0);
    EXPECT_NEAR(first.dcg, (1.0 + kGainAt3) / 2.0, 1e-9);
    EXPECT_NEAR(first.mean_average_precision, (1.0 + 2.0 / 3.0) / 2.0, 1e-12);

    // Query 1: nothing in the first two, all in the first four. Gains 1/log2(3) + 1/log2(4).
    const RetrievalMetrics& second = report.per_query[1].metrics;
    EXPECT_DOUBLE_EQ(second.nearest_neighbor, 0.0);
    EXPECT_DOUBLE_EQ(second.first_tier, 0.0);
    EXPECT_DOUBLE_EQ(second.second_tier, 1.0);
    EXPECT_NEAR(second.dcg, (kGainAt3 + 0.5) / 2.0, 1e-9);
    EXPECT_NEAR(second.mean_average_precision, (1.0 / 3.0 + 2.0 / 4.0) / 2.0, 1e-12);

    // Query 3: one other model, at the last rank; second tier looks at two results.
    const RetrievalMetrics& fourth = report.per_query[3].metrics;
    EXPECT_DOUBLE_EQ(fourth.first_tier, 0.0);
    EXPECT_DOUBLE_EQ(fourth.second_tier, 0.0);
    EXPECT_DOUBLE_EQ(fourth.e_measure, 2.0 / 5.0);  // P = 1/4, R = 1
    EXPECT_NEAR(fourth.dcg, 0.5, 1e-12);
    EXPECT_DOUBLE_EQ(fourth.mean_average_precision, 0.25);

    EXPECT_DOUBLE_EQ(report.mean.nearest_neighbor, 3.0 / 5.0);
    EXPECT_DOUBLE_EQ(report.mean.first_tier, (0.5 + 0.0 + 1.0 + 0.0 + 1.0) / 5.0);
    // Class a: (1 + 0 + 1) / 3, class b: (0 + 1) / 2.
    EXPECT_DOUBLE_EQ(report.per_class[0].metrics.nearest_neighbor, 2.0 / 3.0);
    EXPECT_DOUBLE_EQ(report.per_class[1].metrics.nearest_neighbor, 0.5);
    EXPECT_DOUBLE_EQ(report.macro_mean.nearest_neighbor, (2.0 / 3.0 + 0.5) / 2.0);
    EXPECT_EQ(report.per_class[0].name, "a");
    EXPECT_EQ(report.per_class[0].models, 3U);
    // Neighbours of class a: 1a, 3b, 0a; of class b: 0a, 3b.
    EXPECT_DOUBLE_EQ(report.confusion[0], 2.0 / 3.0);
    EXPECT_DOUBLE_EQ(report.confusion[1], 1.0 / 3.0);
    EXPECT_DOUBLE_EQ(report.confusion[2], 0.5);
    EXPECT_DOUBLE_EQ(report.confusion[3], 0.5);
}

TEST(RetrievalMetrics, InterpolatePrecisionBetweenTheRecallsThatAQueryKnows) {
    const RetrievalReport report = evaluate_retrieval(small_matrix(), kSmallLabels);
    ASSERT_EQ(report.precision_recall.size(), 20U);
    EXPECT_DOUBLE_EQ(report.precision_recall.front().recall, 0.05);
    EXPECT_DOUBLE_EQ(report.precision_recall.back().recall, 1.0);
    // Below 1/2 no query knows a precision.
    for (std::size_t i = 0; i < 9; ++i) {
        EXPECT_EQ(report.precision_recall[i].precision, report.precision_recall[9].precision);
    }
    // At 1/2 class a alone: 1/1, 1/3, 1/1.
    EXPECT_NEAR(report.precision_recall[9].precision, (1.0 + 1.0 / 3.0 + 1.0) / 3.0, 1e-12);
    // At 3/4 halfway between the first and the second precision of each: (1 + 2/3) / 2,
    // (1/3 + 1/2) / 2, 1.
    EXPECT_NEAR(report.precision_recall[14].precision, (5.0 / 6.0 + 5.0 / 12.0 + 1.0) / 3.0, 1e-12);
    // At 1 all five: 2/3, 2/4, 2/2, 1/4, 1/1.
    EXPECT_NEAR(report.precision_recall[19].precision, (2.0 / 3.0 + 0.5 + 1.0 + 0.25 + 1.0) / 5.0,
                1e-12);
}

TEST(RetrievalMetrics, CountOnlyTheFirst32ResultsInTheEMeasure) {
    // 41 models on a line: the query 0 with 9 others of its class, of which 4 lie within the first
    // 32 results: P = 4/32, R = 4/9, E = 2 * 4 / (32 + 9).
    DistanceMatrix matrix;
    matrix.size = 41;
    matrix.values.assign(41 * 41, 1.0F);
    std::vector<std::string> labels(41, "other");
    labels[0] = "query";
    for (const std::size_t rank : {3U, 10U, 31U, 32U, 33U, 34U, 38U, 39U, 40U}) {
        labels[rank] = "query";
    }
    for (std::size_t j = 0; j < 41; ++j) matrix.values[j] = static_cast<float>(j);
    const RetrievalReport report = evaluate_retrieval(matrix, labels);
    EXPECT_DOUBLE_EQ(report.per_query[0].metrics.e_measure, 8.0 / 41.0);
    EXPECT_DOUBLE_EQ(report.per_query[0].metrics.first_tier, 1.0 / 9.0);   // ranks 1 to 9
    EXPECT_DOUBLE_EQ(report.per_query[0].metrics.second_tier, 2.0 / 9.0);  // ranks 1 to 18
}

/// The definitions of the Princeton Shape Benchmark (Shilane et al., 2004, sec. 4), computed from
/// each model's place alone and without the code under test.
RetrievalMetrics by_definition(const DistanceMatrix& matrix, const std::vector<std::string>& labels,
                               std::size_t query) {
    std::vector<double> places;  // of the models of the query's class, 1-based
    for (std::size_t model = 0; model < matrix.size; ++model) {
        if (model == query || labels[model] != labels[query]) continue;
        double place = 1.0;
        for (std::size_t other = 0; other < matrix.size; ++other) {
            if (other == query || other == model) continue;
            if (matrix.at(query, other) < matrix.at(query, model)) place += 1.0;
        }
        places.push_back(place);
    }
    std::sort(places.begin(), places.end());
    const auto size = static_cast<double>(places.size());  // |C| - 1
    const auto share_within = [&](double length) {
        return static_cast<double>(std::count_if(places.begin(), places.end(),
                                                 [&](double place) { return place <= length; })) /
               size;
    };
    RetrievalMetrics metrics;
    metrics.nearest_neighbor = places.front() == 1.0 ? 1.0 : 0.0;
    metrics.first_tier = share_within(size);
    metrics.second_tier = share_within(2.0 * size);
    const double page = std::min(32.0, static_cast<double>(matrix.size - 1));
    const double recall = share_within(page);
    const double precision = recall * size / page;
    metrics.e_measure = recall > 0.0 ? 2.0 / (1.0 / precision + 1.0 / recall) : 0.0;
    double ideal = 1.0;
    for (double rank = 2.0; rank <= size; rank += 1.0) ideal += 1.0 / std::log2(rank);
    for (std::size_t i = 0; i < places.size(); ++i) {
        metrics.dcg += (places[i] == 1.0 ? 1.0 : 1.0 / std::log2(places[i])) / ideal;
        metrics.mean_average_precision += static_cast<double>(i + 1) / places[i] / size;
    }
    return metrics;
}

TEST(RetrievalMetrics, AreThoseOfTheDefinitionsOnRandomMatrices) {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> noise(0.0F, 1.0F);
    for (const std::size_t models : {7U, 33U, 34U, 90U}) {
        DistanceMatrix matrix;
        matrix.size = models;
        std::vector<std::string> labels;
        for (std::size_t i = 0; i < models; ++i) labels.push_back(std::to_string(i * i % 3));
        for (std::size_t i = 0; i < models * models; ++i) {
            const bool alike = labels[i / models] == labels[i % models];
            matrix.values.push_back(noise(random) * (alike ? 0.7F : 1.0F));
        }
        const RetrievalReport report = evaluate_retrieval(matrix, labels);
        ASSERT_EQ(report.per_query.size(), models);
        for (const QueryMetrics& query : report.per_query) {
            const RetrievalMetrics expected = by_definition(matrix, labels, query.model);
            for (const auto measure :
                 {&RetrievalMetrics::nearest_neighbor, &RetrievalMetrics::first_tier,
                  &RetrievalMetrics::second_tier, &RetrievalMetrics::e_measure,
                  &RetrievalMetrics::dcg, &RetrievalMetrics::mean_average_precision}) {
                EXPECT_NEAR(query.metrics.*measure, expected.*measure, 1e-12);
            }
        }
    }
}

TEST(RetrievalMetrics, ArePerfectForClassesThatLieApart) {
    DistanceMatrix matrix;
    matrix.size = 30;
    std::vector<std::string> labels;
    for (std::size_t i = 0; i < 30; ++i) {
        labels.push_back(std::to_string(i % 3));
        for (std::size_t j = 0; j < 30; ++j) matrix.values.push_back(i % 3 == j % 3 ? 0.1F : 0.9F);
    }
    const RetrievalReport report = evaluate_retrieval(matrix, labels);
    EXPECT_DOUBLE_EQ(report.mean.nearest_neighbor, 1.0);
    EXPECT_DOUBLE_EQ(report.mean.first_tier, 1.0);
    EXPECT_DOUBLE_EQ(report.mean.second_tier, 1.0);
    EXPECT_DOUBLE_EQ(report.mean.dcg, 1.0);
    EXPECT_DOUBLE_EQ(report.mean.mean_average_precision, 1.0);
    EXPECT_DOUBLE_EQ(report.mean.e_measure, 2.0 * 9.0 / (29.0 + 9.0));
    for (const PrecisionRecallPoint& point : report.precision_recall) {
        EXPECT_DOUBLE_EQ(point.precision, 1.0) << "recall " << point.recall;
    }
    for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(report.confusion[i], i % 4 == 0 ? 1.0 : 0.0);
}

TEST(RetrievalMetrics, AreAtTheirLeastWhenTheClassComesLast) {
    DistanceMatrix matrix;
    matrix.size = 30;
    std::vector<std::string> labels;
    for (std::size_t i = 0; i < 30; ++i) {
        labels.push_back(std::to_string(i % 3));
        for (std::size_t j = 0; j < 30; ++j) matrix.values.push_back(i % 3 == j % 3 ? 0.9F : 0.1F);
    }
    const RetrievalReport report = evaluate_retrieval(matrix, labels);
    EXPECT_EQ(report.mean.nearest_neighbor, 0.0);
    EXPECT_EQ(report.mean.first_tier, 0.0);
    EXPECT_EQ(report.mean.second_tier, 0.0);
    // All 9 sit at the ranks 21 to 29.
    double gain = 0.0, best = 1.0, precision = 0.0;
    for (int i = 1; i <= 9; ++i) {
        gain += std::log(2.0) / std::log(20.0 + i);
        if (i > 1) best += std::log(2.0) / std::log(static_cast<double>(i));
        precision += i / (20.0 + i) / 9.0;
    }
    EXPECT_NEAR(report.mean.dcg, gain / best, 1e-12);
    EXPECT_NEAR(report.mean.mean_average_precision, precision, 1e-12);
}

TEST(RetrievalMetrics, OfARandomRankingAreThoseOfChance) {
    constexpr std::size_t kModels = 300, kClassSize = 20;
    DistanceMatrix matrix;
    matrix.size = kModels;
    std::mt19937 random(7);
    std::uniform_real_distribution<float> uniform;
    std::vector<std::string> labels;
    for (std::size_t i = 0; i < kModels; ++i) labels.push_back(std::to_string(i / kClassSize));
    for (std::size_t i = 0; i < kModels * kModels; ++i) matrix.values.push_back(uniform(random));
    const RetrievalReport report = evaluate_retrieval(matrix, labels);

    const double share = (kClassSize - 1.0) / (kModels - 1.0);
    double gain = 0.0, best = 0.0;
    for (std::size_t rank = 1; rank < kModels; ++rank) {
        const double at_rank = rank == 1 ? 1.0 : 1.0 / std::log2(static_cast<double>(rank));
        gain += share * at_rank;
        if (rank < kClassSize) best += at_rank;
    }
    EXPECT_NEAR(report.mean.nearest_neighbor, share, 0.05);
    EXPECT_NEAR(report.mean.first_tier, share, 0.015);
    EXPECT_NEAR(report.mean.second_tier, 2.0 * share, 0.02);
    EXPECT_NEAR(report.mean.e_measure, 2.0 * 32.0 * share / (32.0 + 19.0), 0.015);
    EXPECT_NEAR(report.mean.dcg, gain / best, 0.02);
    for (std::size_t i = 0; i < 15; ++i) {
        double row = 0.0;
        for (std::size_t j = 0; j < 15; ++j) row += report.confusion[i * 15 + j];
        EXPECT_NEAR(row, 1.0, 1e-12);
    }
}

TEST(RetrievalMetrics, TakeModelsWithoutAPartnerAsDistractorsOnly) {
    // 0a 1a, and a lone c that stands between them; the unlabelled pair 3, 4 is no class.
    const DistanceMatrix matrix = matrix_of({{0.0F, 0.2F, 0.1F, 0.3F, 0.4F},
                                             {0.2F, 0.0F, 0.1F, 0.3F, 0.4F},
                                             {0.1F, 0.1F, 0.0F, 0.3F, 0.4F},
                                             {0.3F, 0.3F, 0.3F, 0.0F, 0.1F},
                                             {0.4F, 0.4F, 0.4F, 0.1F, 0.0F}});
    for (const char* none : {"", "-1"}) {
        const std::vector<std::string> labels = {"a", "a", "c", none, none};
        const RetrievalReport report = evaluate_retrieval(matrix, labels);
        EXPECT_EQ(report.models, 2U);
        EXPECT_EQ(report.classes, 1U);
        EXPECT_EQ(report.mean.nearest_neighbor, 0.0);
        EXPECT_EQ(report.mean.first_tier, 0.0);
        EXPECT_EQ(report.mean.second_tier, 1.0);
        EXPECT_EQ(report.confusion, std::vector<double>{0.0});
    }
}

TEST(RetrievalMetrics, LeaveOutSmallClassesWhenAsked) {
    const RetrievalReport report =
        evaluate_retrieval(small_matrix(), kSmallLabels, {.min_class_size = 3});
    EXPECT_EQ(report.models, 3U);
    EXPECT_EQ(report.classes, 1U);
    EXPECT_DOUBLE_EQ(report.mean.nearest_neighbor, 2.0 / 3.0);
    EXPECT_DOUBLE_EQ(report.confusion[0], 2.0 / 3.0);  // the neighbour of 1 is of class b
}

TEST(RetrievalMetrics, BreakTiesByIndex) {
    // All equal: the list of each query is the others in order.
    const DistanceMatrix matrix =
        matrix_of({{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}});
    const std::vector<std::string> labels = {"a", "b", "a", "b"};
    const RetrievalReport report = evaluate_retrieval(matrix, labels);
    EXPECT_EQ(report.per_query[0].metrics.nearest_neighbor, 0.0);  // 1b 2a 3b
    EXPECT_EQ(report.per_query[1].metrics.nearest_neighbor, 0.0);  // 0a 2a 3b
    EXPECT_EQ(report.per_query[2].metrics.nearest_neighbor, 1.0);  // 0a 1b 3b
    EXPECT_EQ(report.per_query[3].metrics.second_tier, 1.0);       // 0a 1b 2a
}

TEST(RetrievalMetrics, PutWhatIsNoNumberLast) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const DistanceMatrix matrix =
        matrix_of({{nan, nan, 0.5F}, {0.1F, nan, 0.5F}, {0.1F, 0.2F, nan}});
    const RetrievalReport report =
        evaluate_retrieval(matrix, std::vector<std::string>{"a", "a", "b"});
    EXPECT_EQ(report.per_query[0].metrics.nearest_neighbor, 0.0);
    EXPECT_EQ(report.per_query[0].metrics.second_tier, 1.0);
    EXPECT_EQ(report.per_query[1].metrics.nearest_neighbor, 1.0);
}

TEST(RetrievalMetrics, HandleNothingToEvaluate) {
    EXPECT_EQ(evaluate_retrieval({}, {}).models, 0U);
    const RetrievalReport lone =
        evaluate_retrieval(matrix_of({{0.0F}}), std::vector<std::string>{"a"});
    EXPECT_EQ(lone.models, 0U);
    EXPECT_EQ(lone.mean.nearest_neighbor, 0.0);
    EXPECT_EQ(lone.precision_recall.size(), 20U);
}

}  // namespace
}  // namespace ossuary::ranking
