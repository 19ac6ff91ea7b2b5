#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>

#include "engine/core/whole_file.h"
#include "engine/decomposition/seg_file.h"
#include "index/cli/command.h"
#include "index/cli/console.h"
#include "index/json_text.h"
#include "index/parts_sheet.h"
#include "index/segmentation_evaluation.h"

namespace ossuary::cli {
namespace {

constexpr int kCellPixels = 144;

struct EvaluateSegmentationArguments {
    index::SegmentationEvaluationOptions evaluation;
    std::string classes_path;
    std::string out;
    std::string picture;
    std::string method = "evidence";
    std::string parts = "auto";
};

Result<void> write_all(const std::filesystem::path& folder,
                       const index::SegmentationEvaluation& evaluation) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure) return {ErrorCode::kFileUnwritable, folder.string() + ": " + failure.message()};
    for (const auto& model : evaluation.models) {
        const auto written = write_whole_file(folder / (model.id + ".seg"),
                                              decomposition::to_seg(model.segmentation));
        if (!written.ok()) return written.error();
    }
    const auto written = write_whole_file(folder / "scores.csv", to_csv(evaluation));
    if (!written.ok()) return written.error();
    return write_whole_file(folder / "scores.json",
                            index::json_text(to_json(evaluation), 2) + "\n");
}

void print_evaluation(const index::SegmentationEvaluation& evaluation) {
    Table table({{"class"},
                 {"models", Align::kRight},
                 {"Rand index error", Align::kRight},
                 {"people", Align::kRight},
                 {"Hamming", Align::kRight},
                 {"cut discrepancy", Align::kRight},
                 {"cuts", Align::kRight},
                 {"GCE", Align::kRight},
                 {"LCE", Align::kRight},
                 {"parts", Align::kRight},
                 {"people's", Align::kRight}});
    const auto add = [&](const index::SegmentationEvaluation::Row& row) {
        const index::SegmentationScores& s = row.scores;
        std::vector<std::string> cells = {row.name, std::to_string(row.models)};
        for (const double value :
             {s.rand_index_error, s.people_rand_index_error, s.hamming, s.cut_discrepancy,
              s.registered_cuts, s.global_consistency, s.local_consistency}) {
            cells.push_back(fmt::format("{:.3f}", value));
        }
        cells.push_back(fmt::format("{:.1f}", s.parts));
        cells.push_back(fmt::format("{:.1f}", s.people_parts));
        table.add_row(std::move(cells));
    };
    for (const auto& row : evaluation.per_class) add(row);
    add(evaluation.mean);
    std::cout << table.text();
    if (evaluation.mean_ms > 0.0) {
        std::cout << terminal_format("{:.1f} ms a model in the mean, reading not counted\n",
                                     evaluation.mean_ms);
    }
}

Result<ExitCode> run(EvaluateSegmentationArguments options, const Session& session) {
    const Result<decomposition::DecompositionMethod> method =
        decomposition::parse_decomposition_method(options.method);
    if (!method.ok()) return method.error();
    options.evaluation.decompose.method = *method;
    options.evaluation.parts_of_people = options.parts == "people";
    options.evaluation.jobs = session.jobs;
    if (!options.classes_path.empty()) {
        Result<ranking::Classification> classes =
            ranking::read_classification(options.classes_path);
        if (!classes.ok()) return classes.error();
        options.evaluation.classification = *std::move(classes);
    }
    const Result<index::SegmentationEvaluation> evaluation =
        index::evaluate_segmentation(options.evaluation, session.stop);
    if (!evaluation.ok()) return evaluation.error();
    for (const auto& failure : evaluation->failures) {
        std::cerr << terminal_format("{}: {}: {}\n", failure.id, to_string(failure.error.code),
                                     failure.error.message);
    }
    if (!options.out.empty()) {
        if (const auto written = write_all(options.out, *evaluation); !written.ok()) {
            return written.error();
        }
    }
    if (!options.picture.empty()) {
        const auto png = index::evaluation_sheet(options.evaluation, *evaluation, kCellPixels);
        if (!png.ok()) return png.error();
        const std::string bytes(png->begin(), png->end());
        if (const auto written = write_whole_file(options.picture, bytes); !written.ok()) {
            return written.error();
        }
    }
    if (session.json) {
        print_json(to_json(*evaluation));
    } else {
        print_evaluation(*evaluation);
    }
    if (evaluation->models.empty()) return ExitCode::kFailed;
    return evaluation->failures.empty() ? ExitCode::kDone : ExitCode::kSomeModelsFailed;
}

}  // namespace

void add_evaluate_segmentation(CLI::App& app, Session& session) {
    auto options = std::make_shared<EvaluateSegmentationArguments>();
    CLI::App* command = app.add_subcommand(
        "evaluate-segmentation",
        "Hold parts against those that people made, by the measures of the Princeton benchmark");
    command->add_option("--models", options->evaluation.models, "A folder of models, N.off")
        ->required()
        ->type_name("DIR");
    command
        ->add_option("--truth", options->evaluation.truth,
                     "People's segmentations, N/N_0.seg, N/N_1.seg ...")
        ->required()
        ->type_name("DIR");
    command
        ->add_option("--segmentations", options->evaluation.segmentations,
                     "Evaluate these, N.seg, instead of making some")
        ->type_name("DIR");
    command
        ->add_option("--classes", options->classes_path,
                     "Evaluate the models that this .cla names, and by its classes")
        ->type_name("FILE");
    command
        ->add_option("--parts", options->parts,
                     "auto, or people: as many as people make of the model in the median")
        ->check(CLI::IsMember({"auto", "people"}))
        ->capture_default_str();
    command->add_option("--method", options->method, "evidence (ours) or thesis")
        ->check(CLI::IsMember({"evidence", "thesis"}))
        ->capture_default_str();
    command
        ->add_option("--out", options->out,
                     "Write the segmentations (N.seg), scores.csv and scores.json into this folder")
        ->type_name("DIR");
    command
        ->add_option("--picture", options->picture,
                     "Draw the first model of each class as a PNG: a person's parts, the thesis' "
                     "method's, ours, and those of --segmentations")
        ->type_name("FILE");
    set_body(*command, session, [options, &session] { return run(*options, session); });
}

}  // namespace ossuary::cli
