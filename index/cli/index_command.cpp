#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>

#include "engine/ranking/classification.h"
#include "index/cli/command.h"
#include "index/cli/console.h"
#include "index/cli/options.h"
#include "index/cli/progress.h"
#include "index/indexer.h"
#include "index/presentation.h"

namespace ossuary::cli {
namespace {

struct IndexArguments {
    std::string index_path;
    std::string classes_path;
    std::vector<std::string> paths;
    PipelineOptions pipeline;
    VolumeOptions volume;
    std::string prune = "no";
    std::vector<std::string> exclude;
    std::string up = "auto";
    bool split = false;
    bool retry_failed = false;
    double model_timeout_seconds = index::IndexOptions{}.model_timeout_seconds;
};

// What the user leaves open is as in the index that is there.
Result<index::IndexParameters> parameters_for(const IndexArguments& options) {
    index::IndexParameters defaults;
    if (std::filesystem::exists(options.index_path)) {
        Result<index::Store> existing =
            index::Store::open(options.index_path, index::Access::kReadOnly);
        // An empty file becomes an index; whatever else is wrong is said by create_or_open.
        if (existing.ok()) defaults = existing->parameters();
    }
    return options.pipeline.parameters(defaults);
}

index::Prune prune_mode(const std::string& word) {
    if (word == "force") return index::Prune::kForce;
    return word == "yes" ? index::Prune::kYes : index::Prune::kNo;
}

/// What was asked for and not done, since it may be a mistake.
void print_refusals(const std::vector<index::PruneRefusal>& refusals, const Session& session) {
    for (const index::PruneRefusal& refusal : refusals) {
        print_error({ErrorCode::kPruneRefused,
                     fmt::format("{}: no model file is there, but the index has {} models of it; "
                                 "none of them was removed. If they are really gone, and not on a "
                                 "disk that is not mounted, --prune=force removes them",
                                 refusal.place.string(), refusal.models)},
                    session);
    }
}

/// The worst of what happened to single files and folders.
ExitCode exit_code_of(const index::IndexOutcome& outcome) {
    if (!outcome.refusals.empty()) return exit_code_for(ErrorCode::kPruneRefused);
    const bool all_well =
        outcome.failed + outcome.known_failures == 0 && outcome.unreadable.empty();
    return all_well ? ExitCode::kDone : ExitCode::kSomeModelsFailed;
}

void print_outcome(const index::IndexOutcome& outcome, const std::string& index_path) {
    std::string text = fmt::format("{} indexed", outcome.indexed);
    const auto add = [&](std::size_t count, const char* what) {
        if (count > 0) text += fmt::format(", {} {}", count, what);
    };
    add(outcome.unchanged, "unchanged");
    add(outcome.moved, "moved");
    add(outcome.classified, "with a new class");
    add(outcome.turned, "turned");
    add(outcome.pruned, "removed");
    add(outcome.failed, "failed");
    add(outcome.known_failures, "failed before (--retry-failed tries them again)");
    std::cout << terminal_format("{}: {} of {} files in {}\n", index_path, text, outcome.files,
                                 duration_text(outcome.seconds));
}

Result<ExitCode> run(const IndexArguments& options, const Session& session) {
    const Result<index::IndexParameters> parameters = parameters_for(options);
    if (!parameters.ok()) return parameters.error();

    index::IndexOptions index_options;
    index_options.paths.assign(options.paths.begin(), options.paths.end());
    index_options.jobs = session.jobs;
    index_options.reader = session.reader.get();
    index_options.prune = prune_mode(options.prune);
    for (const std::string& pattern : options.exclude) {
        Result<index::Glob> glob = index::Glob::parse(pattern);
        if (!glob.ok()) {
            return {glob.error().code, "--exclude " + glob.error().message};
        }
        index_options.walk.exclude.push_back(*std::move(glob));
    }
    index_options.inside = options.volume.inside;
    index_options.split = options.split;
    index_options.retry_failed = options.retry_failed;
    index_options.model_timeout_seconds = options.model_timeout_seconds;
    const auto up = parse_up_or_auto(options.up);
    if (!up.ok()) return up.error();
    index_options.up = *up;
    if (!options.classes_path.empty()) {
        Result<ranking::Classification> classes =
            ranking::read_classification(options.classes_path);
        if (!classes.ok()) return classes.error();
        index_options.classes = *std::move(classes);
    }

    Result<index::Store> store = index::Store::create_or_open(options.index_path, *parameters);
    if (!store.ok()) return store.error();
    const Result<index::IndexOutcome> outcome = [&] {
        ConsoleProgress progress;
        return index::index_models(*store, index_options, progress, session.stop);
    }();
    if (!outcome.ok()) return outcome.error();
    if (session.json) {
        print_json(index::to_json(*outcome));
    } else {
        print_outcome(*outcome, options.index_path);
    }
    print_refusals(outcome->refusals, session);
    return exit_code_of(*outcome);
}

}  // namespace

void add_index(CLI::App& app, Session& session) {
    auto options = std::make_shared<IndexArguments>();
    CLI::App* command = app.add_subcommand("index", "Index models, or bring an index up to date");
    add_index_option(*command, options->index_path);
    command->add_option("PATH", options->paths, "Model files, and folders to walk")->required();
    command
        ->add_option("--classes", options->classes_path,
                     "Princeton classification (.cla) that names the models' classes")
        ->type_name("FILE");
    options->pipeline.add_to(*command);
    options->volume.add_to(*command);
    command
        ->add_option("--exclude", options->exclude,
                     "Pass over files and folders whose name, or with a / in it whose path below "
                     "PATH, fits this pattern of *, ?, [a-z] and **; may be given again")
        ->expected(1)
        ->take_all()
        ->type_name("GLOB");
    command->add_flag("--split", options->split,
                      "Index each object of a file that tells several apart (3MF, glTF, OBJ, …) as "
                      "a model of its own, FILE#OBJECT; reads every file");
    command
        ->add_option(
            "--up", options->up,
            "The axis that points up in these models, x, y or z; or auto: as its file says "
            "or found for each new one, and others stay as they are")
        ->check(CLI::IsMember({"x", "y", "z", "auto"}))
        ->capture_default_str();
    command
        ->add_flag("--prune{yes}", options->prune,
                   "Remove models under PATH from the index whose files are gone or passed over. "
                   "Where PATH holds no model file any more, as when a disk is not mounted, models "
                   "go only with --prune=force")
        ->check(CLI::IsMember({"yes", "force"}));
    command->add_flag("--retry-failed", options->retry_failed,
                      "Try unchanged files again that failed before");
    command
        ->add_option("--model-timeout", options->model_timeout_seconds,
                     "Seconds that one model may take (0 = for ever)")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    set_body(*command, session, [options, &session] { return run(*options, session); });
}

}  // namespace ossuary::cli
