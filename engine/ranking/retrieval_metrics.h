#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "engine/ranking/ranker.h"

namespace ossuary::ranking {

/// Retrieval quality of one query, or the mean over several. Definitions are those of the Princeton
/// Shape Benchmark (Shilane et al., "The Princeton Shape Benchmark", SMI 2004, sec. 4): leave one
/// out, the query itself removed from its ranked list of N - 1 models. |C| is the size of the
/// query's class with the query.
struct RetrievalMetrics {
    double nearest_neighbor = 0.0;  ///< 1 where the first model is of the query's class
    double first_tier = 0.0;        ///< share of the class among the first |C| - 1
    double second_tier = 0.0;       ///< share of the class among the first 2(|C| - 1)
    double e_measure = 0.0;         ///< 2 / (1/P + 1/R) over the first min(32, N - 1) results
    double dcg = 0.0;  ///< gain 1 at ranks 1 and 2, 1 / log2(rank) after, over the best possible
    double mean_average_precision = 0.0;  ///< precision at each model of the class, averaged
};

struct PrecisionRecallPoint {
    double recall = 0.0;
    double precision = 0.0;
};

struct ClassMetrics {
    std::string name;
    std::size_t models = 0;
    RetrievalMetrics metrics;
};

struct QueryMetrics {
    std::size_t model = 0;  ///< row of the matrix
    RetrievalMetrics metrics;
};

struct RetrievalReport {
    std::size_t models = 0;       ///< queries: models of classes with enough members
    std::size_t classes = 0;      ///< classes that the queries are of
    RetrievalMetrics mean;        ///< over all queries (micro average)
    RetrievalMetrics macro_mean;  ///< over classes, each the mean of its queries
    /// 20 points, recall .05 … 1, averaged over queries. A query of a class with m others knows the
    /// precision at recall 1/m, 2/m … 1; between these it is interpolated linearly, and below 1/m
    /// the query takes no part in the mean, as with the Princeton tool psbPlot. Below the
    /// lowest recall that any query knows the curve is level.
    std::vector<PrecisionRecallPoint> precision_recall;
    std::vector<ClassMetrics> per_class;  ///< in order of first appearance, `classes` of them
    /// confusion[i * classes + j]: share of queries of class i whose nearest neighbour is of class
    /// j. A row sums to less than 1 where neighbours are of classes that are no queries.
    std::vector<double> confusion;
    std::vector<QueryMetrics> per_query;  ///< in the order of the matrix
};

struct RetrievalOptions {
    /// Smaller classes are no queries, but stay in the ranked lists of others. The paper leaves out
    /// what has nothing to find; the tools psbTable and psbPlot average from 3 members on.
    std::size_t min_class_size = 2;
};

/// @param labels  class of each model, as long as the matrix is wide; an empty label and "-1" (the
///                benchmark's miscellaneous class) stand for no class: never a query, never
///                relevant. Ties in distance are broken by index, and what is not a number comes
///                last, so that the report is a function of the matrix alone.
RetrievalReport evaluate_retrieval(const DistanceMatrix& distances,
                                   std::span<const std::string> labels,
                                   const RetrievalOptions& options = {});

/// The distances of one query to all models of a collection, its own place among them.
struct QueryDistances {
    std::size_t query = 0;
    std::vector<float> distances;
};

/// The same for some of the models as queries, each against all others: a row of what would be the
/// matrix for each. Classes none of whose models is a query are left out; of the others `models`
/// are all that the collection has, and the means are those of their queries.
RetrievalReport evaluate_queries(std::span<const QueryDistances> queries,
                                 std::span<const std::string> labels,
                                 const RetrievalOptions& options = {});

/// The models that evaluate_retrieval takes for queries, ascending.
[[nodiscard]] std::vector<std::size_t> retrieval_queries(std::span<const std::string> labels,
                                                         const RetrievalOptions& options = {});

}  // namespace ossuary::ranking
