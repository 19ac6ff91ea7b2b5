#include "index/report.h"

#include <cassert>
#include <fstream>

#include "index/report_text.h"

namespace ossuary::index {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kStyle = R"(
body { font: 15px/1.5 system-ui, sans-serif; color: #1d232b; margin: 2rem auto; max-width: 76rem;
       padding: 0 1rem; }
h1 { font-size: 1.6rem; } h2 { font-size: 1.2rem; margin-top: 2.5rem; }
figure { margin: 1rem 0; } figure svg { width: 100%; max-width: 44rem; height: auto; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; } caption { text-align: left; padding-bottom: .4rem; }
th, td { padding: .2rem .6rem; text-align: right; border-bottom: 1px solid #e3e6ea; }
th:first-child, td:first-child { text-align: left; }
thead th { border-bottom: 2px solid #9aa4b0; font-weight: 600; }
.confusion th, .confusion td { padding: .1rem .25rem; font-size: .75rem; min-width: 1.6rem;
       text-align: center; border: 0; }
.confusion tbody th { text-align: right; white-space: nowrap; }
.confusion thead th { writing-mode: vertical-rl; transform: rotate(180deg); text-align: left;
       border: 0; }
)";

struct Measure {
    const char* name;
    const char* title;
    double RetrievalMetrics::*value;
};
constexpr Measure kMeasures[] = {
    {"nearest_neighbor", "Nearest neighbour", &RetrievalMetrics::nearest_neighbor},
    {"first_tier", "First tier", &RetrievalMetrics::first_tier},
    {"second_tier", "Second tier", &RetrievalMetrics::second_tier},
    {"e_measure", "E-measure", &RetrievalMetrics::e_measure},
    {"dcg", "DCG", &RetrievalMetrics::dcg},
    {"mean_average_precision", "Mean average precision", &RetrievalMetrics::mean_average_precision},
};

std::string table_head(std::string_view first, std::string_view second) {
    std::string html = "<thead><tr><th scope=\"col\">" + std::string(first) +
                       "</th><th scope=\"col\">" + std::string(second) + "</th>";
    for (const Measure& measure : kMeasures) {
        html += "<th scope=\"col\">" + std::string(measure.title) + "</th>";
    }
    return html + "</tr></thead>\n";
}

std::string table_row(std::string_view name, std::size_t models, const RetrievalMetrics& metrics) {
    std::string html = "<tr><th scope=\"row\">" + markup_text(name) + "</th><td>" +
                       std::to_string(models) + "</td>";
    for (const Measure& measure : kMeasures) {
        html += "<td>" + fixed(metrics.*measure.value, 3) + "</td>";
    }
    return html + "</tr>\n";
}

std::string confusion_table(const RetrievalReport& report) {
    std::string html =
        "<div class=\"wide\"><table class=\"confusion\"><caption>Share of the queries of a class "
        "(row) whose nearest neighbour is of a class (column), in percent</caption><thead><tr>"
        "<td></td>";
    for (const ClassMetrics& one : report.per_class) {
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

Result<void> write_text(const fs::path& path, std::string_view text) {
    std::ofstream file(path, std::ios::binary);
    file.write(text.data(), static_cast<std::streamsize>(text.size()));
    file.close();
    if (!file) return {ErrorCode::kFileUnwritable, path.string() + ": cannot be written"};
    return {};
}

}  // namespace

std::string precision_recall_csv(std::span<const Evaluation> evaluations) {
    std::string csv = "ranker,rerank,recall,precision\n";
    for (const Evaluation& evaluation : evaluations) {
        for (const PrecisionRecallPoint& each : evaluation.report.precision_recall) {
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
                             const RetrievalMetrics& metrics) {
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
        for (const ClassMetrics& one : evaluation.report.per_class) {
            add(one.name, one.models, one.metrics);
        }
    }
    return csv;
}

std::string report_html(std::span<const Evaluation> evaluations) {
    std::string html =
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
        "<meta name=\"viewport\" content=\"width=device-width\">"
        "<title>Retrieval report</title><style>" +
        std::string(kStyle) + "</style></head><body>\n<h1>Retrieval report</h1>\n";
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
            "<div class=\"wide\"><table>" + table_head("Ranker", "Models") + "<tbody>\n";
    for (const Evaluation& evaluation : evaluations) {
        html += table_row(evaluation_title(evaluation), evaluation.report.models,
                          evaluation.report.mean);
    }
    html += "</tbody></table></div>\n";
    for (const Evaluation& evaluation : evaluations) {
        html += "<h2>Classes: " + markup_text(evaluation_title(evaluation)) +
                "</h2>\n<div class=\"wide\"><table>" + table_head("Class", "Models") + "<tbody>\n";
        for (const ClassMetrics& one : evaluation.report.per_class) {
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
        {"precision-recall.csv", precision_recall_csv(evaluations)},
        {"precision-recall.svg", precision_recall_svg(evaluations)},
    };
    for (const auto& [name, text] : files) {
        if (const auto written = write_text(folder / name, text); !written) return written.error();
    }
    return {};
}

}  // namespace ossuary::index
