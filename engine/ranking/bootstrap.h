#pragma once

#include <span>

#include "engine/ranking/retrieval_metrics.h"

namespace ossuary::ranking {

/// A mean over queries with the interval that it would lie in for other queries of the same kind.
struct BootstrapMean {
    double mean = 0.0;
    double low = 0.0;   ///< 2.5th percentile
    double high = 0.0;  ///< 97.5th percentile
};

/// The percentile bootstrap over 2,000 resamples of the values (Efron and Tibshirani, "An
/// introduction to the bootstrap", 1993, sec. 13.3); the same for the same values. All zero for
/// none.
[[nodiscard]] BootstrapMean bootstrap_mean(std::span<const double> values);

/// A measure over a report's queries.
[[nodiscard]] BootstrapMean bootstrap_measure(const RetrievalReport& report,
                                              double RetrievalMetrics::*measure);

/// How much better `second` is than `first` in a measure, query by query, so that what makes some
/// queries hard for both does not widen the interval.
/// @pre both reports are of the same queries in the same order
[[nodiscard]] BootstrapMean bootstrap_difference(const RetrievalReport& first,
                                                 const RetrievalReport& second,
                                                 double RetrievalMetrics::*measure);

}  // namespace ossuary::ranking
