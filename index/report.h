#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "engine/core/result.h"
#include "index/evaluation.h"

namespace ossuary::index {

/// Precision over recall of one or more evaluations as a stand-alone SVG picture.
[[nodiscard]] std::string precision_recall_svg(std::span<const Evaluation> evaluations);

/// The same as comma-separated values: ranker,rerank,recall,precision.
[[nodiscard]] std::string precision_recall_csv(std::span<const Evaluation> evaluations);

/// Metrics overall and by class: ranker,rerank,class,models and the six measures.
[[nodiscard]] std::string metrics_csv(std::span<const Evaluation> evaluations);

/// Each two evaluations of the same queries against each other: the difference of each measure with
/// its 95 % bootstrap interval: first,second,measure,difference,low,high.
[[nodiscard]] std::string comparisons_csv(std::span<const Evaluation> evaluations);

/// One page that needs nothing else: the plot, the metrics with their intervals, the rankers
/// against each other, each class, confusion.
[[nodiscard]] std::string report_html(std::span<const Evaluation> evaluations);

/// Writes report.html, metrics.csv, comparisons.csv, precision-recall.csv and precision-recall.svg
/// into `folder`, which is made if need be.
Result<void> write_report(const std::filesystem::path& folder,
                          std::span<const Evaluation> evaluations);

}  // namespace ossuary::index
