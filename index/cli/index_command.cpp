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

struct Options {
    std::string index_path;
    std::string classes_path;
    std::vector<std::string> paths;
    PipelineOptions pipeline;
    bool prune = false;
    bool retry_failed = false;
    double model_timeout_seconds = index::IndexOptions{}.model_timeout_seconds;
};

// What the user leaves open is as in the index that is there.
Result<index::IndexParameters> parameters_for(const Options& options) {
    index::IndexParameters defaults;
    if (std::filesystem::exists(options.index_path)) {
        Result<index::Store> existing =
            index::Store::open(options.index_path, index::Access::kReadOnly);
        // An empty file becomes an index; whatever else is wrong is said by create_or_open.
        if (existing.ok()) defaults = existing->parameters();
    }
    return options.pipeline.parameters(defaults);
}

void print_outcome(const index::IndexOutcome& outcome, const std::string& index_path) {
    std::string text = fmt::format("{} indexed", outcome.indexed);
    const auto add = [&](std::size_t count, const char* what) {
        if (count > 0) text += fmt::format(", {} {}", count, what);
    };
    add(outcome.unchanged, "unchanged");
    add(outcome.moved, "moved");
    add(outcome.classified, "with a new class");
    add(outcome.pruned, "removed");
    add(outcome.failed, "failed");
    add(outcome.known_failures, "failed before (--retry-failed tries them again)");
    std::cout << fmt::format("{}: {} of {} files in {}\n", index_path, text, outcome.files,
                             duration_text(outcome.seconds));
}

Result<ExitCode> run(const Options& options, const Session& session) {
    const Result<index::IndexParameters> parameters = parameters_for(options);
    if (!parameters.ok()) return parameters.error();

    index::IndexOptions index_options;
    index_options.paths.assign(options.paths.begin(), options.paths.end());
    index_options.jobs = session.jobs;
    index_options.prune = options.prune;
    index_options.retry_failed = options.retry_failed;
    index_options.model_timeout_seconds = options.model_timeout_seconds;
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
    return outcome->failed + outcome->known_failures > 0 ? ExitCode::kSomeModelsFailed
                                                         : ExitCode::kDone;
}

}  // namespace

void add_index(CLI::App& app, Session& session) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("index", "Index models, or bring an index up to date");
    add_index_option(*command, options->index_path);
    command->add_option("PATH", options->paths, "Model files, and folders to walk")->required();
    command
        ->add_option("--classes", options->classes_path,
                     "Princeton classification (.cla) that names the models' classes")
        ->type_name("FILE");
    options->pipeline.add_to(*command);
    command->add_flag("--prune", options->prune,
                      "Remove models under PATH whose files are gone from the index");
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
