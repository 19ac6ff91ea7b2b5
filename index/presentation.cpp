#include "index/presentation.h"

#include <cassert>
#include <utility>

#include "engine/ranking/bootstrap.h"
#include "index/unit.h"

namespace ossuary::index {

namespace {

using nlohmann::json;

json point(const Vec3& value) { return {value.x(), value.y(), value.z()}; }

json number_or_null(const std::optional<double>& number) { return number ? json(*number) : json(); }

json class_or_null(const std::string& name) { return name.empty() ? json() : json(name); }

json pairs(const std::vector<matching::Correspondence::Pair>& list) {
    json out = json::array();
    for (const auto& pair : list)
        out.push_back({{"a", pair.a}, {"b", pair.b}, {"cost", pair.cost}});
    return out;
}

constexpr std::pair<const char*, double ranking::RetrievalMetrics::*> kMetricNames[] = {
    {"nearest_neighbor", &ranking::RetrievalMetrics::nearest_neighbor},
    {"first_tier", &ranking::RetrievalMetrics::first_tier},
    {"second_tier", &ranking::RetrievalMetrics::second_tier},
    {"e_measure", &ranking::RetrievalMetrics::e_measure},
    {"dcg", &ranking::RetrievalMetrics::dcg},
    {"mean_average_precision", &ranking::RetrievalMetrics::mean_average_precision},
};

void add_metrics(json& out, const ranking::RetrievalMetrics& metrics) {
    for (const auto& [name, measure] : kMetricNames) out[name] = metrics.*measure;
}

/// The 95 % bootstrap interval of each measure.
json intervals(const ranking::RetrievalReport& report) {
    json out = json::object();
    for (const auto& [name, measure] : kMetricNames) {
        const ranking::BootstrapMean interval = ranking::bootstrap_measure(report, measure);
        out[name] = {{"low", interval.low}, {"high", interval.high}};
    }
    return out;
}

/// {unit, metres_per_unit}
void add_unit(json& out, const FileFrame& frame) {
    const bool known = frame.metres_per_unit > 0.0;
    out["unit"] = known ? json(unit_name(frame.metres_per_unit)) : json();
    out["metres_per_unit"] = known ? json(frame.metres_per_unit) : json();
}

/// Who says which axis of a model points up.
std::string_view up_from(const ModelSummary& model) {
    if (model.orientation.said_by_person) return "person";
    return model.frame.up == model.orientation.up ? "file" : "shape";
}

std::string_view name_of(PreviewColours::Of of) {
    switch (of) {
        case PreviewColours::Of::kNothing:
            break;
        case PreviewColours::Of::kModel:
            return "model";
        case PreviewColours::Of::kVertices:
            return "vertices";
        case PreviewColours::Of::kTriangles:
            return "triangles";
        case PreviewColours::Of::kCorners:
            return "corners";
    }
    return "nothing";
}

json to_json(const PreviewColours& colours) {
    if (colours.of == PreviewColours::Of::kNothing) return {};
    return {{"of", name_of(colours.of)}, {"values", colours.bytes}};
}

json compared(const ComparedModel& model) {
    if (model.summary.id != 0) return to_json(model.summary);
    json out = json::object();
    out["name"] = model.summary.name;
    return out;
}

json skeleton_json(const skeleton::SkeletonGraph& graph, std::string_view unit,
                   std::span<const std::string> chain_codes) {
    json nodes = json::array();
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
        const skeleton::SkeletonGraph::Node& node = graph.nodes[i];
        nodes.push_back({{"id", i},
                         {"position", point(node.position)},
                         {"radius", node.radius},
                         {"degree", node.degree},
                         {"significance", node.significance}});
    }
    json branches = json::array();
    for (std::size_t i = 0; i < graph.branches.size(); ++i) {
        const skeleton::SkeletonGraph::Branch& branch = graph.branches[i];
        json points = json::array();
        for (const Vec3& each : branch.points) points.push_back(point(each));
        json one = {{"id", i},
                    {"a", branch.a},
                    {"b", branch.b},
                    {"length", branch.length()},
                    {"points", std::move(points)},
                    {"radii", branch.radii}};
        if (i < chain_codes.size()) one["chain_code"] = chain_codes[i];
        branches.push_back(std::move(one));
    }
    return {{"unit", unit}, {"nodes", std::move(nodes)}, {"branches", std::move(branches)}};
}

json placement_json(const std::optional<registration::PiecePlacement>& placed) {
    if (!placed) return {};
    const Eigen::Matrix4d matrix = placed->placement.matrix();
    json rows = json::array();
    for (int row = 0; row < 4; ++row) {
        rows.push_back({matrix(row, 0), matrix(row, 1), matrix(row, 2), matrix(row, 3)});
    }
    return {{"matrix", std::move(rows)},
            {"scale", placed->placement.scale},
            {"explained", placed->explained}};
}

}  // namespace

json to_json(const Box3& box) { return {{"min", point(box.min())}, {"max", point(box.max())}}; }

json to_json(const std::vector<mesh::MeshWarning>& warnings) {
    json out = json::array();
    for (const mesh::MeshWarning& warning : warnings) {
        out.push_back(
            {{"code", warning.code}, {"count", warning.count}, {"message", warning.message}});
    }
    return out;
}

json to_json(const StageTimes& times) {
    json out = json::object();
    for (const StageTime& time : times) {
        out[time.stage] = out.value(time.stage, 0.0) + time.milliseconds;
    }
    return out;
}

json to_json(const std::vector<matching::DistancePart>& parts) {
    json out = json::object();
    for (const matching::DistancePart& part : parts) out[part.name] = part.value;
    return out;
}

json to_json(const matching::Correspondence& match) {
    return {{"nodes", pairs(match.nodes)},
            {"branches", pairs(match.branches)},
            {"cluster_sizes", match.cluster_sizes}};
}

json to_json(const StoredSkeleton& skeleton) {
    return skeleton_json(skeleton.graph, "model", skeleton.chain_codes);
}

json to_json(const skeleton::SkeletonGraph& graph, std::string_view unit) {
    return skeleton_json(graph, unit, {});
}

json to_json(const decomposition::Decomposition::Part& part, double total_area) {
    return {{"triangles", part.triangles},
            {"area", part.area},
            {"area_share", total_area > 0.0 ? part.area / total_area : 0.0},
            {"branch", part.branch >= 0 ? json(part.branch) : json()},
            {"neighbors", part.neighbors}};
}

json to_json(const PreviewMesh& mesh, const Box3& bounds) {
    return {{"origin", {mesh.origin.x(), mesh.origin.y(), mesh.origin.z()}},
            {"positions", mesh.positions},
            {"triangles", mesh.triangles},
            {"colours", to_json(mesh.colours)},
            {"bounds", to_json(bounds)}};
}

json to_json(const ModelSummary& model) {
    json out = {{"id", model.id},
                {"name", model.name},
                {"class", class_or_null(model.class_name)},
                {"path", model.path},
                {"content_hash", model.content_hash},
                {"vertices", model.vertices},
                {"faces", model.faces},
                {"nodes", model.nodes},
                {"branches", model.branches},
                {"bounds", to_json(model.bounds)},
                {"surface_area", model.surface_area},
                {"up", to_string(model.orientation.up)},
                {"up_from", up_from(model)},
                {"indexed_at", model.indexed_at},
                {"warnings", to_json(model.warnings)}};
    add_unit(out, model.frame);
    return out;
}

json to_json(const Failure& failure) {
    return {{"path", failure.path},
            {"content_hash", failure.content_hash.empty() ? json() : json(failure.content_hash)},
            {"code", failure.code},
            {"message", failure.message},
            {"failed_at", failure.failed_at}};
}

json to_json(const Hit& hit) {
    return {{"rank", hit.rank},
            {"id", hit.id},
            {"name", hit.name},
            {"class", class_or_null(hit.class_name)},
            {"path", hit.path},
            {"faces", hit.faces},
            {"extent", point(hit.extent)},
            {"copies", hit.copies},
            {"distance", hit.distance},
            {"parts", to_json(hit.parts)},
            {"build_difference", number_or_null(hit.build)},
            {"pose_difference", number_or_null(hit.pose)},
            {"matched_nodes", hit.matched_nodes},
            {"placement", placement_json(hit.placement)},
            {"match", to_json(hit.match)}};
}

json to_json(const SearchResult& result, const QueryDescription& query,
             const ranking::RankOptions& options) {
    json hits = json::array();
    for (const Hit& hit : result.hits) hits.push_back(to_json(hit));
    json about = {{"name", query.name},
                  {"vertices", query.vertices},
                  {"faces", query.faces},
                  {"warnings", to_json(result.warnings)},
                  {"skeleton", to_json(result.query_skeleton)}};
    add_unit(about, query.frame);
    if (query.up) about["up"] = to_string(*query.up);
    return {{"took_ms", result.took_ms},
            {"stages_ms", to_json(result.stages_ms)},
            {"ranker", to_string(options.ranker)},
            {"pose", options.pose},
            {"size", options.size},
            {"rerank", options.rerank},
            {"part", options.part},
            {"models", result.models},
            {"revision", result.revision},
            {"query", std::move(about)},
            {"hits", std::move(hits)}};
}

json to_json(const Comparison& comparison, const ranking::RankOptions& options) {
    return {{"a", compared(comparison.a)},
            {"b", compared(comparison.b)},
            {"ranker", to_string(options.ranker)},
            {"pose", options.pose},
            {"part", options.part},
            {"distance", comparison.match.distance},
            {"parts", to_json(comparison.match.parts)},
            {"build_difference", number_or_null(comparison.match.build)},
            {"pose_difference", number_or_null(comparison.match.pose)},
            {"matched_nodes", comparison.match.correspondence.nodes.size()},
            {"match", to_json(comparison.match.correspondence)},
            {"skeletons",
             {{"a", to_json(comparison.a.skeleton)}, {"b", to_json(comparison.b.skeleton)}}}};
}

json to_json(const Evaluation& evaluation) {
    const ranking::RetrievalReport& report = evaluation.report;
    json out = {{"models", report.models},
                {"classes", report.classes},
                {"ranker", to_string(evaluation.ranker)},
                {"rerank", evaluation.rerank},
                {"pose", evaluation.pose},
                {"revision", evaluation.revision},
                {"computed_at", evaluation.computed_at},
                {"missing", evaluation.missing}};
    add_metrics(out, report.mean);
    out["queries_total"] = evaluation.queries;
    out["intervals"] = intervals(report);
    json macro = json::object();
    add_metrics(macro, report.macro_mean);
    out["macro_mean"] = std::move(macro);
    json curve = json::array();
    for (const ranking::PrecisionRecallPoint& each : report.precision_recall) {
        curve.push_back({{"recall", each.recall}, {"precision", each.precision}});
    }
    out["precision_recall"] = std::move(curve);
    json per_class = json::object();
    json names = json::array();
    for (const ranking::ClassMetrics& each : report.per_class) {
        json one = {{"models", each.models}};
        add_metrics(one, each.metrics);
        per_class[each.name] = std::move(one);
        names.push_back(each.name);
    }
    out["per_class"] = std::move(per_class);
    json rows = json::array();
    const std::size_t n = report.classes;
    assert(report.confusion.size() == n * n);
    for (std::size_t i = 0; i < n; ++i) {
        const auto first = report.confusion.begin() + static_cast<std::ptrdiff_t>(i * n);
        rows.push_back(std::vector<double>(first, first + static_cast<std::ptrdiff_t>(n)));
    }
    out["confusion"] = {{"classes", std::move(names)}, {"values", std::move(rows)}};
    return out;
}

json queries_json(const Evaluation& evaluation, const Snapshot& snapshot,
                  const Catalogue& catalogue) {
    json queries = json::array();
    for (const ranking::QueryMetrics& each : evaluation.report.per_query) {
        const ModelId id = evaluation.order[each.model];
        const auto position = snapshot.find(id);
        json one = {{"model", id},
                    {"name", position ? std::string(catalogue[*position].name) : std::string()},
                    {"class", evaluation.labels[each.model]}};
        add_metrics(one, each.metrics);
        queries.push_back(std::move(one));
    }
    return queries;
}

json to_json(const PassedOver& passed_over) {
    return {{"hidden", passed_over.hidden},           {"excluded", passed_over.excluded},
            {"seen_before", passed_over.seen_before}, {"broken_links", passed_over.broken_links},
            {"special", passed_over.special},         {"other_files", passed_over.other_files}};
}

json to_json(const IndexOutcome& outcome) {
    json unreadable = json::array();
    for (const UnreadableFolder& each : outcome.unreadable) {
        unreadable.push_back({{"path", each.path.string()},
                              {"code", to_string(each.error.code)},
                              {"message", each.error.message}});
    }
    json refusals = json::array();
    for (const PruneRefusal& each : outcome.refusals) {
        refusals.push_back(
            {{"path", each.place.string()}, {"models", each.models}, {"gone", each.gone}});
    }
    return {{"files", outcome.files},
            {"indexed", outcome.indexed},
            {"moved", outcome.moved},
            {"unchanged", outcome.unchanged},
            {"failed", outcome.failed},
            {"known_failures", outcome.known_failures},
            {"classified", outcome.classified},
            {"turned", outcome.turned},
            {"pruned", outcome.pruned},
            {"prune_refused", std::move(refusals)},
            {"passed_over", to_json(outcome.passed_over)},
            {"unreadable", std::move(unreadable)},
            {"revision", outcome.revision},
            {"seconds", outcome.seconds}};
}

json to_json(const VerifyReport& report) {
    json findings = json::array();
    for (const Finding& finding : report.findings) {
        findings.push_back({{"subject", finding.subject}, {"message", finding.message}});
    }
    return {{"sound", report.findings.empty()},
            {"models", report.models},
            {"blobs", report.blobs},
            {"failures", report.failures},
            {"uploads", report.uploads},
            {"version", report.version},
            {"revision", report.revision},
            {"findings", std::move(findings)}};
}

json to_json(const IndexParameters& parameters) {
    return {{"resolution", parameters.resolution},
            {"thinning", to_string(parameters.thinning)},
            {"pipeline", parameters.pipeline}};
}

}  // namespace ossuary::index
