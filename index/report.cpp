#include "index/report.h"

#include <algorithm>
#include <cassert>

#include "engine/core/whole_file.h"
#include "engine/ranking/bootstrap.h"
#include "index/report_text.h"

namespace ossuary::index {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kReportStyle = R"(
body { font: 15px/1.5 system-ui, sans-serif; color: #1d232b; margin: 2rem auto; max-width: 76rem;
       padding: 0 1rem; }
h1 { font-size: 1.6rem; } h2 { font-size: 1.2rem; margin-top: 2.5rem; }
figure { margin: 1rem 0; } figure svg { width: 100%; max-width: 44rem; height: auto; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; } caption { text-align: left; padding-bottom: .4rem; }
th, td { padding: .2rem .6rem; text-align: right; border-bottom: 1px solid #e3e6ea; }
th:first-child, td:first-child { text-align: left; }
thead th { border-bottom: 2px solid #9aa4b0; font-weight: 600; }
td small { display: block; color: #5a6470; }
.confusion th, .confusion td { padding: .1rem .25rem; font-size: .75rem; min-width: 1.6rem;
       text-align: center; border: 0; }
.confusion tbody th { text-align: right; white-space: nowrap; }
.confusion thead th { writing-mode: vertical-rl; transform: rotate(180deg); text-align: left;
       border: 0; }
)";

struct Measure {
    const char* name;
    const char* title;
    double ranking::RetrievalMetrics::*value;
};
constexpr Measure kMeasures[] = {
    {"nearest_neighbor", "Nearest neighbour", &ranking::RetrievalMetrics::nearest_neighbor},
    {"first_tier", "First tier", &ranking::RetrievalMetrics::first_tier},
    {"second_tier", "Second tier", &ranking::RetrievalMetrics::second_tier},
    {"e_measure", "E-measure", &ranking::RetrievalMetrics::e_measure},
    {"dcg", "DCG", &ranking::RetrievalMetrics::dcg},
    {"mean_average_precision", "Mean average precision",
     &ranking::RetrievalMetrics::mean_average_precision},
};

std::string table_head(std::string_view first, std::string_view second) {
    std::string html = "<thead><tr><th scope=\"col\">" + std::string(first) +
                       "</th><th scope=\"col\">" + std::string(second) + "</th>";
    for (const Measure& measure : kMeasures) {
        html += "<th scope=\"col\">" + std::string(measure.title) + "</th>";
    }
    return html + "</tr></thead>\n";
}

std::string table_row(std::string_view name, std::size_t models,
                      const ranking::RetrievalMetrics& metrics) {
    std::string html = "<tr><th scope=\"row\">" + markup_text(name) + "</th><td>" +
                       std::to_string(models) + "</td>";
    for (const Measure& measure : kMeasures) {
        html += "<td>" + fixed(metrics.*measure.value, 3) + "</td>";
    }
    return html + "</tr>\n";
}

/// A table of the means over all queries with their intervals.
std::string interval_table(std::span<const Evaluation> evaluations) {
    std::string html =
        "<div class=\"wide\"><table><caption>In brackets the 95 % interval of the "
        "bootstrap over queries</caption>" +
        table_head("Ranker", "Models") + "<tbody>\n";
    for (const Evaluation& evaluation : evaluations) {
        html += "<tr><th scope=\"row\">" + markup_text(evaluation_title(evaluation)) + "</th><td>" +
                std::to_string(evaluation.report.models) + "</td>";
        for (const Measure& measure : kMeasures) {
            const ranking::BootstrapMean found =
                ranking::bootstrap_measure(evaluation.report, measure.value);
            html += "<td>" + fixed(found.mean, 3) + "<small>[" + fixed(found.low, 3) + ", " +
                    fixed(found.high, 3) + "]</small></td>";
        }
        html += "</tr>\n";
    }
    return html + "</tbody></table></div>\n";
}

bool same_queries(const ranking::RetrievalReport& a, const ranking::RetrievalReport& b) {
    return std::equal(a.per_query.begin(), a.per_query.end(), b.per_query.begin(),
                      b.per_query.end(),
                      [](const ranking::QueryMetrics& x, const ranking::QueryMetrics& y) {
                          return x.model == y.model;
                      });
}

/// Calls body(first, second) for each two evaluations that can be compared query by query.
template <typename Body>
void for_each_pair(std::span<const Evaluation> evaluations, const Body& body) {
    for (std::size_t i = 0; i < evaluations.size(); ++i) {
        for (std::size_t j = i + 1; j < evaluations.size(); ++j) {
            if (!same_queries(evaluations[i].report, evaluations[j].report)) continue;
            body(evaluations[i], evaluations[j]);
        }
    }
}

std::string comparison_rows(std::span<const Evaluation> evaluations) {
    std::string html;
    for_each_pair(evaluations, [&](const Evaluation& first, const Evaluation& second) {
        html += "<tr><th scope=\"row\">" + markup_text(evaluation_title(second)) + " against " +
                markup_text(evaluation_title(first)) + "</th><td>" +
                std::to_string(first.report.models) + "</td>";
        for (const Measure& measure : kMeasures) {
            const ranking::BootstrapMean gain =
                ranking::bootstrap_difference(first.report, second.report, measure.value);
            const bool certain = gain.low > 0.0 || gain.high < 0.0;
            html += std::string(certain ? "<td><b>" : "<td>") + fixed(gain.mean, 3) +
                    (certain ? "</b>" : "") + "<small>[" + fixed(gain.low, 3) + ", " +
                    fixed(gain.high, 3) + "]</small></td>";
        }
        html += "</tr>\n";
    });
    return html;
}

std::string confusion_table(const ranking::RetrievalReport& report) {
    std::string html =
        "<div class=\"wide\"><table class=\"confusion\"><caption>Share of the queries of a class "
        "(row) whose nearest neighbour is of a class (column), in percent</caption><thead><tr>"
        "<td></td>";
    for (const ranking::ClassMetrics& one : report.per_class) {
        html += "<th scope=\"col\">" + markup_text(one.name) + "</th>";
    }
    html += "</tr></thead><tbody>\n";
    const std::size_t n = report.per_class.size();
    assert(report.confusion.size() == n * n);
    for (std::size_t i = 0; i < n; ++i) {
        html += "<tr><th scope=\"row\">" + markup_text(report.per_class[i].name) + "</th>";
        for (std::size_t j = 0; j < n; ++j) {
            const double share = report.confusion[i * n + j];
            if (share <= 0.0) {
                html += "<td></td>";
                continue;
            }
            const std::string_view tone = i == j ? "31, 119, 80" : "190, 60, 40";
            html += "<td style=\"background: rgba(" + std::string(tone) + ", " +
                    fixed(0.08 + 0.72 * share, 2) + ")\">" + fixed(100.0 * share, 0) + "</td>";
        }
        html += "</tr>\n";
    }
    return html + "</tbody></table></div>\n";
}

}  // namespace

std::string precision_recall_csv(std::span<const Evaluation> evaluations) {
    std::string csv = "ranker,rerank,recall,precision\n";
    for (const Evaluation& evaluation : evaluations) {
        for (const ranking::PrecisionRecallPoint& each : evaluation.report.precision_recall) {
            csv += std::string(to_string(evaluation.ranker)) +
                   (evaluation.rerank ? ",true," : ",false,") + shortest(each.recall) + "," +
                   shortest(each.precision) + "\n";
        }
    }
    return csv;
}

std::string metrics_csv(std::span<const Evaluation> evaluations) {
    std::string csv = "ranker,rerank,class,models";
    for (const Measure& measure : kMeasures) {
        csv += ',';
        csv += measure.name;
    }
    csv += "\n";
    for (const Evaluation& evaluation : evaluations) {
        const auto add = [&](std::string_view name, std::size_t models,
                             const ranking::RetrievalMetrics& metrics) {
            csv += std::string(to_string(evaluation.ranker)) +
                   (evaluation.rerank ? ",true," : ",false,") + csv_field(name) + "," +
                   std::to_string(models);
            for (const Measure& measure : kMeasures) {
                csv += ',';
                csv += shortest(metrics.*measure.value);
            }
            csv += "\n";
        };
        add("", evaluation.report.models, evaluation.report.mean);
        for (const ranking::ClassMetrics& one : evaluation.report.per_class) {
            add(one.name, one.models, one.metrics);
        }
    }
    return csv;
}

std::string comparisons_csv(std::span<const Evaluation> evaluations) {
    std::string csv = "first,second,measure,difference,low,high\n";
    for_each_pair(evaluations, [&](const Evaluation& first, const Evaluation& second) {
        for (const Measure& measure : kMeasures) {
            const ranking::BootstrapMean gain =
                ranking::bootstrap_difference(first.report, second.report, measure.value);
            csv += csv_field(evaluation_title(first)) + "," + csv_field(evaluation_title(second)) +
                   "," + measure.name + "," + shortest(gain.mean) + "," + shortest(gain.low) + "," +
                   shortest(gain.high) + "\n";
        }
    });
    return csv;
}

std::string report_html(std::span<const Evaluation> evaluations) {
    std::string html =
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
        "<meta name=\"viewport\" content=\"width=device-width\">"
        "<title>Retrieval report</title><style>" +
        std::string(kReportStyle) + "</style></head><body>\n<h1>Retrieval report</h1>\n";
    if (!evaluations.empty()) {
        const Evaluation& first = evaluations.front();
        html += "<p>" + std::to_string(first.report.models) + " models of " +
                std::to_string(first.report.classes) +
                " classes, each the query once and left out of its own list; computed " +
                markup_text(first.computed_at) + ", index revision " +
                std::to_string(first.revision) + ".</p>\n";
        if (!first.missing.empty()) {
            html += "<p>" + std::to_string(first.missing.size()) +
                    " models of the classification are not in the index.</p>\n";
        }
    }
    html += "<figure>" + precision_recall_svg(evaluations) + "</figure>\n<h2>All queries</h2>\n" +
            interval_table(evaluations);
    if (const std::string rows = comparison_rows(evaluations); !rows.empty()) {
        html +=
            "<h2>Rankers against each other</h2>\n<div class=\"wide\"><table><caption>Gain "
            "query by query with its 95 % bootstrap interval; bold where that leaves out "
            "0</caption>" +
            table_head("Rankers", "Models") + "<tbody>\n" + rows + "</tbody></table></div>\n";
    }
    for (const Evaluation& evaluation : evaluations) {
        html += "<h2>Classes: " + markup_text(evaluation_title(evaluation)) +
                "</h2>\n<div class=\"wide\"><table>" + table_head("Class", "Models") + "<tbody>\n";
        for (const ranking::ClassMetrics& one : evaluation.report.per_class) {
            html += table_row(one.name, one.models, one.metrics);
        }
        html += "</tbody></table></div>\n" + confusion_table(evaluation.report);
    }
    return html + "</body></html>\n";
}

Result<void> write_report(const fs::path& folder, std::span<const Evaluation> evaluations) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error && !fs::is_directory(folder)) {
        return {ErrorCode::kFileUnwritable, folder.string() + ": " + error.message()};
    }
    const std::pair<const char*, std::string> files[] = {
        {"report.html", report_html(evaluations)},
        {"metrics.csv", metrics_csv(evaluations)},
        {"comparisons.csv", comparisons_csv(evaluations)},
        {"precision-recall.csv", precision_recall_csv(evaluations)},
        {"precision-recall.svg", precision_recall_svg(evaluations)},
    };
    for (const auto& [name, text] : files) {
        if (const auto written = write_whole_file(folder / name, text); !written) {
            return written.error();
        }
    }
    return {};
}

}  // namespace ossuary::index
