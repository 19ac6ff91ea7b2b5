#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "engine/ranking/ranker.h"

namespace ossuary {

/// Retrieval quality of one query, or the mean over several. Definitions are those of the Princeton
/// Shape Benchmark (Shilane et al., "The Princeton Shape Benchmark", SMI 2004, sec. 4): leave one
/// out, the query itself removed from its ranked list.
struct RetrievalMetrics {
    double nearest_neighbor = 0.0;
    double first_tier = 0.0;
    double second_tier = 0.0;
    double e_measure = 0.0;  ///< over the first 32 results
    double dcg = 0.0;        ///< normalised
    double mean_average_precision = 0.0;
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

struct RetrievalReport {
    std::size_t models = 0;  ///< queries: models of classes with at least two members
    std::size_t classes = 0;
    RetrievalMetrics mean;                               ///< over all queries
    std::vector<PrecisionRecallPoint> precision_recall;  ///< 20 points, recall .05 … 1
    std::vector<ClassMetrics> per_class;                 ///< in order of first appearance
    /// confusion[i * classes + j]: share of queries of class i whose nearest neighbour is of class
    /// j
    std::vector<double> confusion;
};

/// @param labels  class of each model, as long as the matrix is wide; ties in distance are broken
/// by
///                index, so that the report is a function of the matrix alone
RetrievalReport evaluate_retrieval(const DistanceMatrix& distances,
                                   std::span<const std::string> labels);

}  // namespace ossuary
