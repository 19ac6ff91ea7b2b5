#include "index/segmentation_evaluation.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "engine/core/parallel.h"
#include "engine/core/stopwatch.h"
#include "engine/decomposition/cut_discrepancy.h"
#include "engine/decomposition/registered_cuts.h"
#include "engine/decomposition/seg_file.h"
#include "engine/mesh/measures.h"
#include "engine/mesh/read_mesh.h"
#include "index/json_text.h"
#include "index/report_text.h"

namespace ossuary::index {
namespace {

namespace fs = std::filesystem;

using Model = SegmentationEvaluation::Model;

constexpr double decomposition::SegmentationErrors::*kErrors[] = {
    &decomposition::SegmentationErrors::rand_index_error,
    &decomposition::SegmentationErrors::hamming,
    &decomposition::SegmentationErrors::hamming_missing,
    &decomposition::SegmentationErrors::hamming_false_alarm,
    &decomposition::SegmentationErrors::global_consistency,
    &decomposition::SegmentationErrors::local_consistency,
    &decomposition::SegmentationErrors::global_consistency_area,
    &decomposition::SegmentationErrors::local_consistency_area,
};

struct ScoreField {
    const char* name;
    double SegmentationScores::*value;
};
constexpr ScoreField kScoreFields[] = {
    {"rand_index_error", &SegmentationScores::rand_index_error},
    {"hamming", &SegmentationScores::hamming},
    {"hamming_missing", &SegmentationScores::hamming_missing},
    {"hamming_false_alarm", &SegmentationScores::hamming_false_alarm},
    {"cut_discrepancy", &SegmentationScores::cut_discrepancy},
    {"consistency_error", &SegmentationScores::global_consistency},
    {"local_consistency_error", &SegmentationScores::local_consistency},
    {"consistency_error_area", &SegmentationScores::global_consistency_area},
    {"local_consistency_error_area", &SegmentationScores::local_consistency_area},
    {"registered_cuts", &SegmentationScores::registered_cuts},
    {"additional_cuts", &SegmentationScores::additional_cuts},
    {"missing_cuts", &SegmentationScores::missing_cuts},
    {"people_registered_cuts", &SegmentationScores::people_registered_cuts},
    {"people_rand_index_error", &SegmentationScores::people_rand_index_error},
    {"parts", &SegmentationScores::parts},
    {"people_parts", &SegmentationScores::people_parts},
};

/// The numbers of the models first, in order, then other names.
bool id_before(const ranking::ClassifiedModel& a, const ranking::ClassifiedModel& b) {
    const auto number = [](const std::string& id) {
        long value = 0;
        const auto [end, failure] = std::from_chars(id.data(), id.data() + id.size(), value);
        return failure == std::errc{} && end == id.data() + id.size() ? value : -1L;
    };
    const long x = number(a.id), y = number(b.id);
    return x != y ? x < y : a.id < b.id;
}

std::vector<ranking::ClassifiedModel> models_to_evaluate(
    const SegmentationEvaluationOptions& options) {
    if (options.classification) return ranking::models_in_order(*options.classification);
    std::vector<ranking::ClassifiedModel> models;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(options.models, ignored)) {
        const std::string id = entry.path().stem().string();
        // As evaluate_model reads it: a model may lie there in other formats too.
        const bool is_off = entry.path().extension() == ".off";
        if (!is_off || !fs::is_directory(options.truth / id, ignored)) continue;
        models.push_back({id, ""});
    }
    std::sort(models.begin(), models.end(), id_before);
    return models;
}

double median_parts(const std::vector<decomposition::Segmentation>& truths) {
    std::vector<std::uint32_t> parts;
    for (const decomposition::Segmentation& truth : truths) parts.push_back(truth.parts);
    std::sort(parts.begin(), parts.end());
    const std::size_t middle = parts.size() / 2;
    if (parts.size() % 2 == 1) return parts[middle];
    return 0.5 * (parts[middle - 1] + parts[middle]);
}

std::vector<double> face_areas(const mesh::TriangleMesh& mesh) {
    std::vector<double> areas(mesh.face_count, 0.0);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        areas[mesh.face_of_triangle[t]] += mesh::triangle_area(mesh, t);
    }
    return areas;
}

void add_face_scores(const std::vector<decomposition::Segmentation>& truths,
                     const std::vector<double>& areas, Model& model) {
    SegmentationScores& scores = model.scores;
    const double share = 1.0 / static_cast<double>(truths.size());
    for (const decomposition::Segmentation& truth : truths) {
        const decomposition::SegmentationErrors errors =
            decomposition::segmentation_errors(truth, model.segmentation, areas);
        for (const auto error : kErrors) scores.*error += share * (errors.*error);
    }
    std::size_t pairs = 0;
    double sum = 0.0;
    for (std::size_t i = 0; i < truths.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j, ++pairs) {
            sum += decomposition::segmentation_errors(truths[i], truths[j], areas).rand_index_error;
        }
    }
    if (pairs > 0) scores.people_rand_index_error = sum / static_cast<double>(pairs);
    scores.parts = model.segmentation.parts;
    scores.people_parts = median_parts(truths);
}

void add_cut_discrepancy(const std::vector<decomposition::Segmentation>& truths,
                         const mesh::TriangleMesh& mesh, Model& model) {
    const decomposition::CutDiscrepancy discrepancy(mesh);
    const auto ours =
        discrepancy.cuts_of(decomposition::triangle_segmentation(mesh, model.segmentation));
    double sum = 0.0;
    int defined = 0;
    for (const decomposition::Segmentation& truth : truths) {
        const auto value = discrepancy(
            discrepancy.cuts_of(decomposition::triangle_segmentation(mesh, truth)), ours);
        if (!value) continue;
        sum += *value;
        ++defined;
    }
    model.has_cut_discrepancy = defined > 0;
    if (defined > 0) model.scores.cut_discrepancy = sum / defined;
}

void add_registered_cuts(const std::vector<decomposition::Segmentation>& truths,
                         const mesh::TriangleMesh& mesh, Model& model) {
    const double area = mesh::measure(mesh).surface_area;
    if (area <= 0.0) return;
    const double scale = 1.0 / std::sqrt(area);
    const mesh::EdgeTable edges = mesh::build_edge_table(mesh);
    const auto cuts_of = [&](const decomposition::Segmentation& faces) {
        return decomposition::find_cuts(mesh, edges,
                                        decomposition::triangle_segmentation(mesh, faces));
    };
    const std::vector<decomposition::Cut> made = cuts_of(model.segmentation);
    std::vector<std::vector<decomposition::Cut>> people;
    for (const decomposition::Segmentation& truth : truths) people.push_back(cuts_of(truth));
    SegmentationScores& scores = model.scores;
    const double share = scale / static_cast<double>(truths.size());
    double sum = 0.0;
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < people.size(); ++i) {
        const decomposition::RegisteredCuts found = decomposition::register_cuts(people[i], made);
        scores.registered_cuts += share * found.total();
        scores.additional_cuts += share * found.additional;
        scores.missing_cuts += share * found.missing;
        for (std::size_t j = 0; j < people.size(); ++j) {
            if (i == j) continue;
            sum += scale * decomposition::register_cuts(people[i], people[j]).total();
            ++pairs;
        }
    }
    if (pairs > 0) scores.people_registered_cuts = sum / static_cast<double>(pairs);
}

Result<decomposition::Segmentation> segmentation_of(
    const mesh::TriangleMesh& mesh, const SegmentationEvaluationOptions& options,
    const std::vector<decomposition::Segmentation>& truths, Model& model, std::stop_token stop) {
    if (!options.segmentations.empty()) {
        return decomposition::read_seg(options.segmentations / (model.id + ".seg"),
                                       mesh.face_count);
    }
    decomposition::DecomposeOptions decompose_options = options.decompose;
    if (options.parts_of_people) {
        decompose_options.parts = static_cast<std::size_t>(median_parts(truths));
    }
    Stopwatch watch;
    const Result<decomposition::Decomposition> decomposition =
        decomposition::decompose(mesh, decompose_options, stop);
    if (!decomposition.ok()) return decomposition.error();
    model.took_ms = watch.elapsed_ms();
    return decomposition::face_segmentation(mesh, decomposition->segmentation);
}

Result<Model> evaluate_model(const ranking::ClassifiedModel& named,
                             const SegmentationEvaluationOptions& options, std::stop_token stop) {
    Model model{named.id, named.class_name, {}, {}, false, 0.0};
    // Its files are named by it, also those that are written.
    if (named.id.find('/') != std::string::npos) {
        return Error{ErrorCode::kClaInvalid,
                     "model '" + named.id + "': expected the name of a file, without '/'"};
    }
    const auto read = mesh::read_mesh(options.models / (named.id + ".off"));
    if (!read.ok()) return read.error();
    const auto truths =
        decomposition::read_segmentations(options.truth, named.id, read->mesh.face_count);
    if (!truths.ok()) return truths.error();
    if (truths->empty()) {
        return Error{ErrorCode::kFileNotFound,
                     (options.truth / named.id).string() + ": no .seg files"};
    }
    Result<decomposition::Segmentation> made =
        segmentation_of(read->mesh, options, *truths, model, stop);
    if (!made.ok()) return made.error();
    model.segmentation = *std::move(made);
    add_face_scores(*truths, face_areas(read->mesh), model);
    add_cut_discrepancy(*truths, read->mesh, model);
    add_registered_cuts(*truths, read->mesh, model);
    return model;
}

SegmentationEvaluation::Row mean_of(const std::string& name,
                                    const std::vector<const Model*>& models) {
    SegmentationEvaluation::Row row{name, models.size(), {}};
    const auto defined = static_cast<double>(std::count_if(
        models.begin(), models.end(), [](auto* m) { return m->has_cut_discrepancy; }));
    for (const ScoreField& field : kScoreFields) {
        double sum = 0.0;
        for (const Model* model : models) sum += model->scores.*field.value;
        const bool is_cut = field.value == &SegmentationScores::cut_discrepancy;
        const double count = is_cut ? defined : static_cast<double>(models.size());
        row.scores.*field.value = count > 0.0 ? sum / count : 0.0;
    }
    return row;
}

void add_means(SegmentationEvaluation& evaluation) {
    std::vector<std::string> names;
    std::vector<const Model*> all;
    double total_ms = 0.0;
    for (const Model& model : evaluation.models) {
        all.push_back(&model);
        total_ms += model.took_ms;
        if (model.class_name.empty()) continue;
        if (std::find(names.begin(), names.end(), model.class_name) == names.end()) {
            names.push_back(model.class_name);
        }
    }
    for (const std::string& name : names) {
        std::vector<const Model*> members;
        std::copy_if(all.begin(), all.end(), std::back_inserter(members),
                     [&](const Model* model) { return model->class_name == name; });
        evaluation.per_class.push_back(mean_of(name, members));
    }
    evaluation.mean = mean_of("mean", all);
    if (!all.empty()) evaluation.mean_ms = total_ms / static_cast<double>(all.size());
}

nlohmann::json row_json(const SegmentationEvaluation::Row& row) {
    nlohmann::json document = {{"models", row.models}};
    for (const ScoreField& field : kScoreFields) document[field.name] = row.scores.*field.value;
    return document;
}

}  // namespace

Result<SegmentationEvaluation> evaluate_segmentation(const SegmentationEvaluationOptions& options,
                                                     std::stop_token stop) {
    std::error_code ignored;
    for (const fs::path& folder : {options.models, options.truth, options.segmentations}) {
        if (folder.empty() || fs::is_directory(folder, ignored)) continue;
        return Error{ErrorCode::kFileNotFound, folder.string() + ": no such folder"};
    }
    const std::vector<ranking::ClassifiedModel> named = models_to_evaluate(options);
    if (named.empty()) {
        return Error{
            ErrorCode::kModelNotFound,
            options.models.string() + ": no model with segmentations in " + options.truth.string()};
    }
    std::vector<std::optional<Result<Model>>> outcomes(named.size());
    parallel_for(named.size(), options.jobs, [&](std::size_t i) {
        if (!stop.stop_requested()) outcomes[i] = evaluate_model(named[i], options, stop);
    });
    if (stop.stop_requested()) return Error{ErrorCode::kCancelled, "the evaluation was cancelled"};
    SegmentationEvaluation evaluation;
    for (std::size_t i = 0; i < named.size(); ++i) {
        if (outcomes[i]->ok()) {
            evaluation.models.push_back(**std::move(outcomes[i]));
        } else {
            evaluation.failures.push_back({named[i].id, outcomes[i]->error()});
        }
    }
    add_means(evaluation);
    return evaluation;
}

nlohmann::json to_json(const SegmentationEvaluation& evaluation) {
    nlohmann::json document = row_json(evaluation.mean);
    document["mean_ms"] = evaluation.mean_ms;
    document["per_class"] = nlohmann::json::array();
    for (const auto& row : evaluation.per_class) {
        document["per_class"].push_back(row_json(row));
        document["per_class"].back()["class"] = row.name;
    }
    document["failures"] = nlohmann::json::array();
    for (const auto& failure : evaluation.failures) {
        document["failures"].push_back({{"model", failure.id},
                                        {"code", to_string(failure.error.code)},
                                        {"message", failure.error.message}});
    }
    return document;
}

std::string to_csv(const SegmentationEvaluation& evaluation) {
    std::string csv = "model,class";
    for (const ScoreField& field : kScoreFields) csv += std::string(",") + field.name;
    csv += "\n";
    for (const Model& model : evaluation.models) {
        csv += csv_field(model.id) + "," + csv_field(model.class_name);
        for (const ScoreField& field : kScoreFields) {
            const bool undefined =
                field.value == &SegmentationScores::cut_discrepancy && !model.has_cut_discrepancy;
            csv += "," + (undefined ? std::string()
                                    : json_text(nlohmann::json(model.scores.*field.value)));
        }
        csv += "\n";
    }
    return csv;
}

}  // namespace ossuary::index
