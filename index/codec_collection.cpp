// What is stored of a whole collection, and warnings.

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "index/blob.h"
#include "index/bytes.h"
#include "index/codec.h"
#include "index/json_text.h"

namespace ossuary::index {

namespace {

void put_metrics(ByteWriter& writer, const ranking::RetrievalMetrics& metrics) {
    writer.put(metrics.nearest_neighbor);
    writer.put(metrics.first_tier);
    writer.put(metrics.second_tier);
    writer.put(metrics.e_measure);
    writer.put(metrics.dcg);
    writer.put(metrics.mean_average_precision);
}

ranking::RetrievalMetrics get_metrics(ByteReader& reader) {
    ranking::RetrievalMetrics metrics;
    metrics.nearest_neighbor = reader.get<double>();
    metrics.first_tier = reader.get<double>();
    metrics.second_tier = reader.get<double>();
    metrics.e_measure = reader.get<double>();
    metrics.dcg = reader.get<double>();
    metrics.mean_average_precision = reader.get<double>();
    return metrics;
}

constexpr std::size_t kMetricsSize = 6 * sizeof(double);

}  // namespace

std::string encode_statistics(const ranking::CollectionStatistics& statistics) {
    ByteWriter writer;
    writer.put(static_cast<std::uint32_t>(statistics.values.size()));
    writer.put_all<double>(statistics.values);
    return seal_blob(kStatisticsBlob, writer.bytes());
}

Result<ranking::CollectionStatistics> decode_statistics(std::string_view blob) {
    const auto payload = open_blob(kStatisticsBlob, blob);
    if (!payload) return payload.error();
    ByteReader reader(*payload);
    ranking::CollectionStatistics statistics;
    statistics.values = reader.get_all<double>(reader.get_count(8));
    if (!reader.ok() || !reader.at_end()) {
        return {ErrorCode::kIndexCorrupt, "STAT blob: wrong length"};
    }
    if (!std::all_of(statistics.values.begin(), statistics.values.end(),
                     [](double value) { return std::isfinite(value); })) {
        return {ErrorCode::kIndexCorrupt, "STAT blob: a number that is not finite"};
    }
    return statistics;
}

std::string encode_report(const ranking::RetrievalReport& report) {
    ByteWriter writer;
    writer.put(static_cast<std::uint64_t>(report.models));
    put_metrics(writer, report.mean);
    put_metrics(writer, report.macro_mean);
    writer.put(static_cast<std::uint32_t>(report.precision_recall.size()));
    for (const ranking::PrecisionRecallPoint& point : report.precision_recall) {
        writer.put(point.recall);
        writer.put(point.precision);
    }
    writer.put(static_cast<std::uint32_t>(report.per_class.size()));
    for (const ranking::ClassMetrics& one : report.per_class) {
        writer.put_text(one.name);
        writer.put(static_cast<std::uint64_t>(one.models));
        put_metrics(writer, one.metrics);
    }
    writer.put_all<double>(report.confusion);
    writer.put(static_cast<std::uint32_t>(report.per_query.size()));
    for (const ranking::QueryMetrics& query : report.per_query) {
        writer.put(static_cast<std::uint64_t>(query.model));
        put_metrics(writer, query.metrics);
    }
    return seal_blob(kEvaluationBlob, writer.bytes());
}

Result<ranking::RetrievalReport> decode_report(std::string_view blob) {
    const auto payload = open_blob(kEvaluationBlob, blob);
    if (!payload) return payload.error();
    ByteReader reader(*payload);
    ranking::RetrievalReport report;
    report.models = reader.get<std::uint64_t>();
    report.mean = get_metrics(reader);
    report.macro_mean = get_metrics(reader);
    report.precision_recall.resize(reader.get_count(16));
    for (ranking::PrecisionRecallPoint& point : report.precision_recall) {
        point.recall = reader.get<double>();
        point.precision = reader.get<double>();
    }
    report.per_class.resize(reader.get_count(12 + kMetricsSize));
    for (ranking::ClassMetrics& one : report.per_class) {
        one.name = reader.get_text();
        one.models = reader.get<std::uint64_t>();
        one.metrics = get_metrics(reader);
    }
    report.classes = report.per_class.size();
    report.confusion = reader.get_all<double>(report.classes * report.classes);
    report.per_query.resize(reader.get_count(8 + kMetricsSize));
    for (ranking::QueryMetrics& query : report.per_query) {
        query.model = reader.get<std::uint64_t>();
        query.metrics = get_metrics(reader);
    }
    if (!reader.ok() || !reader.at_end()) {
        return {ErrorCode::kIndexCorrupt, "EVAL blob: wrong length"};
    }
    return report;
}

std::string encode_warnings(const std::vector<mesh::MeshWarning>& warnings) {
    nlohmann::json list = nlohmann::json::array();
    for (const mesh::MeshWarning& warning : warnings) {
        list.push_back(
            {{"code", warning.code}, {"count", warning.count}, {"message", warning.message}});
    }
    // Messages may quote a file's bytes: what is not UTF-8 is replaced.
    return json_text(list);
}

Result<std::vector<mesh::MeshWarning>> decode_warnings(std::string_view text) {
    const Error corrupt{ErrorCode::kIndexCorrupt, "warnings: not a list of {code, count, message}"};
    const auto list = nlohmann::json::parse(text, nullptr, false);
    if (!list.is_array()) return corrupt;
    std::vector<mesh::MeshWarning> warnings;
    for (const auto& item : list) {
        if (!item.is_object() || !item.contains("code") || !item["code"].is_string() ||
            !item.contains("count") || !item["count"].is_number_unsigned() ||
            !item.contains("message") || !item["message"].is_string()) {
            return corrupt;
        }
        warnings.push_back({item["code"].get<std::string>(), item["count"].get<std::size_t>(),
                            item["message"].get<std::string>()});
    }
    return warnings;
}

}  // namespace ossuary::index
