#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

#include "engine/core/parallel.h"
#include "engine/core/whole_file.h"
#include "engine/ranking/classification.h"
#include "index/build_and_pose.h"
#include "index/cli/command.h"
#include "index/cli/console.h"
#include "index/cli/options.h"
#include "index/evaluation.h"
#include "index/pose_gallery.h"
#include "index/presentation.h"
#include "index/report.h"
#include "index/searcher.h"

namespace ossuary::cli {
namespace {

constexpr std::size_t kPosesOfAClass = 5;

struct EvaluateArguments {
    std::string index_path;
    std::string classes_path;
    std::string build_classes_path;
    std::string pose_classes_path;
    std::string matrix_path;
    std::string report_folder;
    RankingOptions ranking;
};

/// One evaluation as one JSON object, several as a list; tables by `print` where no JSON is asked
/// for.
template <typename OneOfThem, typename Print>
void print_all(const Session& session, const std::vector<OneOfThem>& evaluations,
               const Print& print) {
    if (!session.json) {
        for (const OneOfThem& evaluation : evaluations) print(evaluation);
    } else if (evaluations.size() == 1) {
        print_json(index::to_json(evaluations.front()));
    } else {
        nlohmann::json list = nlohmann::json::array();
        for (const OneOfThem& evaluation : evaluations) list.push_back(index::to_json(evaluation));
        print_json(list);
    }
}

std::vector<std::string> metric_cells(const ranking::RetrievalMetrics& m) {
    std::vector<std::string> cells;
    for (const double value : {m.nearest_neighbor, m.first_tier, m.second_tier, m.e_measure, m.dcg,
                               m.mean_average_precision}) {
        cells.push_back(fmt::format("{:.3f}", value));
    }
    return cells;
}

void print_evaluation(const index::Evaluation& evaluation) {
    std::cout << terminal_format("{}{}: {} models in {} classes\n", to_string(evaluation.ranker),
                                 evaluation.rerank ? " with re-ranking" : "",
                                 evaluation.report.models, evaluation.report.classes);
    Table table({{"class"},
                 {"models", Align::kRight},
                 {"NN", Align::kRight},
                 {"first tier", Align::kRight},
                 {"second tier", Align::kRight},
                 {"E-measure", Align::kRight},
                 {"DCG", Align::kRight},
                 {"MAP", Align::kRight}});
    const auto add = [&](const std::string& name, std::size_t models,
                         const ranking::RetrievalMetrics& m) {
        std::vector<std::string> cells = {name, std::to_string(models)};
        for (std::string& cell : metric_cells(m)) cells.push_back(std::move(cell));
        table.add_row(std::move(cells));
    };
    for (const ranking::ClassMetrics& row : evaluation.report.per_class) {
        add(row.name, row.models, row.metrics);
    }
    add("mean over models", evaluation.report.models, evaluation.report.mean);
    std::cout << table.text();
}

/// An evaluation of many models says beforehand what it takes.
void say_what_it_costs(std::size_t models, const Session& session) {
    constexpr std::size_t kFew = 2000;
    if (models <= kFew) return;
    constexpr double kPairMs = 0.035, kDescriptorMb = 0.025, kMatrixMb = 12e-6;
    const auto count = static_cast<double>(models);
    std::cerr << terminal_format(
        "all pairs of up to {} models: up to {:.0f} s for each ranker, {:.0f} MB of memory\n",
        models, 0.5 * count * count * kPairMs / 1000.0 / resolve_jobs(session.jobs),
        count * kDescriptorMb + count * count * kMatrixMb);
}

Result<std::vector<index::Evaluation>> evaluate_all(const EvaluateArguments& options,
                                                    const Session& session,
                                                    const index::Snapshot& snapshot,
                                                    index::StorePool& stores) {
    const Result<std::vector<ranking::RankOptions>> ranks =
        options.ranking.rank_options(session.jobs);
    if (!ranks.ok()) return ranks.error();
    index::EvaluateOptions evaluate_options;
    if (!options.classes_path.empty()) {
        Result<ranking::Classification> classes =
            ranking::read_classification(options.classes_path);
        if (!classes.ok()) return classes.error();
        evaluate_options.classification = *std::move(classes);
    }
    std::vector<index::Evaluation> evaluations;
    for (const ranking::RankOptions& rank : *ranks) {
        evaluate_options.rank = rank;
        Result<index::Evaluation> evaluation = index::evaluate(snapshot, stores, evaluate_options);
        if (!evaluation.ok()) return evaluation.error();
        evaluations.push_back(*std::move(evaluation));
    }
    return evaluations;
}

/// The report, and pictures of what pose does for rankers that know it.
Result<void> write_reports(const EvaluateArguments& options, const Session& session,
                           index::Searcher& searcher, const index::Snapshot& snapshot,
                           const std::vector<index::Evaluation>& evaluations) {
    const auto written = index::write_report(options.report_folder, evaluations);
    if (!written.ok()) return written.error();
    std::cerr << terminal_format("report written to {}/report.html\n", options.report_folder);
    const auto knows_pose = [](const index::Evaluation& evaluation) {
        return evaluation.ranker != ranking::RankerKind::kChainCode;
    };
    if (std::none_of(evaluations.begin(), evaluations.end(), knows_pose)) return {};
    const auto examples = index::pose_examples(snapshot, searcher.stores(), evaluations.front(),
                                               kPosesOfAClass, session.jobs);
    if (!examples.ok()) return examples.error();
    const auto poses =
        index::write_pose_gallery(options.report_folder, searcher.store(), *examples);
    if (!poses.ok()) return poses.error();
    std::cerr << terminal_format("models in like poses in {}/poses.html\n", options.report_folder);
    return {};
}

void print_build_and_pose(const index::BuildAndPose& evaluation) {
    std::cout << terminal_format("{}{}: {} models of {} builds in {} poses\n",
                                 to_string(evaluation.ranker),
                                 evaluation.rerank ? " with re-ranking" : "", evaluation.models,
                                 evaluation.builds, evaluation.poses);
    Table table({{"pose", Align::kRight},
                 {"build: NN", Align::kRight},
                 {"first tier", Align::kRight},
                 {"among other poses: NN", Align::kRight},
                 {"first tier", Align::kRight},
                 {"pose: NN", Align::kRight},
                 {"first tier", Align::kRight},
                 {"among other builds: NN", Align::kRight},
                 {"first tier", Align::kRight}});
    for (const index::BuildAndPose::Point& point : evaluation.curve) {
        std::vector<std::string> cells = {fmt::format("{:.2f}", point.weight)};
        for (const index::BuildAndPose::Question* question : {&point.build, &point.pose}) {
            for (const ranking::AmongOthers* found : {&question->all, &question->others}) {
                cells.push_back(fmt::format("{:.3f}", found->nearest_neighbor));
                cells.push_back(fmt::format("{:.3f}", found->first_tier));
            }
        }
        table.add_row(std::move(cells));
    }
    std::cout << table.text();
    for (const std::string& id : evaluation.missing) {
        std::cout << terminal_format("not in the index: {}\n", id);
    }
}

Result<index::BuildAndPoseOptions> read_build_and_pose(const EvaluateArguments& options) {
    Result<ranking::Classification> builds =
        ranking::read_classification(options.build_classes_path);
    if (!builds.ok()) return builds.error();
    Result<ranking::Classification> poses = ranking::read_classification(options.pose_classes_path);
    if (!poses.ok()) return poses.error();
    return index::BuildAndPoseOptions{*std::move(builds), *std::move(poses), {}};
}

Result<std::vector<index::BuildAndPose>> ask_build_and_pose(const EvaluateArguments& options,
                                                            const Session& session,
                                                            const index::Snapshot& snapshot,
                                                            index::StorePool& stores,
                                                            index::BuildAndPoseOptions asked) {
    const Result<std::vector<ranking::RankOptions>> ranks =
        options.ranking.rank_options(session.jobs);
    if (!ranks.ok()) return ranks.error();
    std::vector<index::BuildAndPose> evaluations;
    for (const ranking::RankOptions& rank : *ranks) {
        asked.rank = rank;
        Result<index::BuildAndPose> evaluation =
            index::evaluate_build_and_pose(snapshot, stores, asked);
        if (!evaluation.ok()) return evaluation.error();
        evaluations.push_back(*std::move(evaluation));
    }
    return evaluations;
}

/// The curves as values, and in the page that shows like poses.
Result<void> write_build_and_pose(const EvaluateArguments& options, const Session& session,
                                  index::Searcher& searcher, const index::Snapshot& snapshot,
                                  const ranking::Classification& builds,
                                  const std::vector<index::BuildAndPose>& evaluations) {
    const auto models = index::classified_models(snapshot, searcher.stores(), builds);
    if (!models.ok()) return models.error();
    index::Evaluation shown;
    shown.labels = models->labels;
    for (const std::size_t position : models->positions) {
        shown.order.push_back(snapshot.id(position));
    }
    const auto examples =
        index::pose_examples(snapshot, searcher.stores(), shown, kPosesOfAClass, session.jobs);
    if (!examples.ok()) return examples.error();
    const auto page = index::write_pose_gallery(options.report_folder, searcher.store(), *examples,
                                                index::build_and_pose_svg(evaluations));
    if (!page.ok()) return page.error();
    std::cerr << terminal_format("curves and models in like poses in {}/poses.html\n",
                                 options.report_folder);
    return write_whole_file(std::filesystem::path(options.report_folder) / "build-and-pose.csv",
                            index::build_and_pose_csv(evaluations));
}

Result<ExitCode> run_build_and_pose(const EvaluateArguments& options, const Session& session) {
    if (options.build_classes_path.empty() || options.pose_classes_path.empty()) {
        return {ErrorCode::kInvalidArgument,
                "--build-classes and --pose-classes: name both or neither"};
    }
    if (!options.classes_path.empty() || !options.matrix_path.empty()) {
        return {ErrorCode::kInvalidArgument,
                "--build-classes: not together with --classes or --matrix"};
    }
    Result<index::Searcher> searcher = index::Searcher::open(options.index_path);
    if (!searcher.ok()) return searcher.error();
    const auto snapshot = searcher->snapshot();
    if (!snapshot.ok()) return snapshot.error();
    const auto asked = read_build_and_pose(options);
    if (!asked.ok()) return asked.error();
    const auto evaluations =
        ask_build_and_pose(options, session, **snapshot, searcher->stores(), *asked);
    if (!evaluations.ok()) return evaluations.error();
    if (!options.report_folder.empty()) {
        const auto written = write_build_and_pose(options, session, *searcher, **snapshot,
                                                  asked->build, *evaluations);
        if (!written.ok()) return written.error();
    }
    print_all(session, *evaluations, print_build_and_pose);
    return ExitCode::kDone;
}

Result<ExitCode> run(const EvaluateArguments& options, const Session& session) {
    if (!options.build_classes_path.empty() || !options.pose_classes_path.empty()) {
        return run_build_and_pose(options, session);
    }
    if (!options.matrix_path.empty() && options.ranking.rankers.size() > 1) {
        return {ErrorCode::kInvalidArgument, "--matrix holds one ranker's distances: name one"};
    }
    Result<index::Searcher> searcher = index::Searcher::open(options.index_path);
    if (!searcher.ok()) return searcher.error();
    const auto snapshot = searcher->snapshot();
    if (!snapshot.ok()) return snapshot.error();
    say_what_it_costs((*snapshot)->size(), session);
    const Result<std::vector<index::Evaluation>> evaluations =
        evaluate_all(options, session, **snapshot, searcher->stores());
    if (!evaluations.ok()) return evaluations.error();
    if (!options.matrix_path.empty()) {
        const auto written =
            index::write_matrix(options.matrix_path, evaluations->front().distances);
        if (!written.ok()) return written.error();
    }
    if (!options.report_folder.empty()) {
        const auto written = write_reports(options, session, *searcher, **snapshot, *evaluations);
        if (!written.ok()) return written.error();
    }
    print_all(session, *evaluations, print_evaluation);
    return ExitCode::kDone;
}

}  // namespace

void add_evaluate(CLI::App& app, Session& session) {
    auto options = std::make_shared<EvaluateArguments>();
    CLI::App* command = app.add_subcommand(
        "evaluate", "Leave-one-out retrieval quality: NN, tiers, E-measure, DCG, MAP, by class");
    add_index_option(*command, options->index_path);
    command
        ->add_option("--classes", options->classes_path,
                     "Evaluate the models that this .cla names, with its classes "
                     "(default: all models, with the classes of the index)")
        ->type_name("FILE");
    command
        ->add_option("--build-classes", options->build_classes_path,
                     "Instead: how well the same body is found, whose models this .cla names, and "
                     "the same pose, at several weights of --pose")
        ->type_name("FILE");
    command
        ->add_option("--pose-classes", options->pose_classes_path,
                     "The poses of these models, a class each")
        ->type_name("FILE");
    options->ranking.add_to(*command, RankingOptions::Count::kSeveral, true);
    command
        ->add_option("--matrix", options->matrix_path,
                     "Write the distances as little-endian float32, rows in the order of the .cla")
        ->type_name("OUT");
    command
        ->add_option("--out", options->report_folder,
                     "Write a report (HTML, CSV, SVG, pictures of like poses) into this folder")
        ->type_name("DIR");
    set_body(*command, session, [options, &session] { return run(*options, session); });
}

}  // namespace ossuary::cli
