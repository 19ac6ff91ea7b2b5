#include <iostream>
#include <memory>

#include "index/cli/command.h"
#include "index/cli/console.h"
#include "index/cli/index_arguments.h"
#include "index/cli/progress.h"
#include "index/indexer.h"
#include "index/presentation.h"

namespace ossuary::cli {
namespace {

struct RunArguments {
    IndexArguments indexing;
    std::string prune = "no";
    bool retry_failed = false;
};

index::Prune prune_mode(const std::string& word) {
    if (word == "force") return index::Prune::kForce;
    return word == "yes" ? index::Prune::kYes : index::Prune::kNo;
}

/// The worst of what happened to single files and folders.
ExitCode exit_code_of(const index::IndexOutcome& outcome) {
    if (!outcome.refusals.empty()) return exit_code_for(ErrorCode::kPruneRefused);
    const bool all_well =
        outcome.failed + outcome.known_failures == 0 && outcome.unreadable.empty();
    return all_well ? ExitCode::kDone : ExitCode::kSomeModelsFailed;
}

Result<ExitCode> run(const RunArguments& arguments, const Session& session) {
    const IndexArguments& indexing = arguments.indexing;
    const Result<index::IndexParameters> parameters = indexing.parameters();
    if (!parameters.ok()) return parameters.error();
    Result<index::IndexOptions> options = indexing.options(session);
    if (!options.ok()) return options.error();
    options->prune = prune_mode(arguments.prune);
    options->retry_failed = arguments.retry_failed;

    Result<index::Store> store = index::Store::create_or_open(indexing.index_path, *parameters);
    if (!store.ok()) return store.error();
    const Result<index::IndexOutcome> outcome = [&] {
        ConsoleProgress progress;
        return index::index_models(*store, *options, progress, session.stop);
    }();
    if (!outcome.ok()) return outcome.error();
    if (session.json) {
        print_json(index::to_json(*outcome));
    } else {
        std::cout << terminal_format("{}: {} of {} files in {}\n", indexing.index_path,
                                     outcome_text(*outcome), outcome->files,
                                     duration_text(outcome->seconds));
    }
    print_refusals(outcome->refusals, session);
    return exit_code_of(*outcome);
}

}  // namespace

void add_index(CLI::App& app, Session& session) {
    auto options = std::make_shared<RunArguments>();
    CLI::App* command = app.add_subcommand("index", "Index models, or bring an index up to date");
    options->indexing.add_to(*command);
    command
        ->add_flag("--prune{yes}", options->prune,
                   "Remove models under PATH from the index whose files are gone or passed over. "
                   "Where PATH holds no model file any more, as when a disk is not mounted, models "
                   "go only with --prune=force")
        ->check(CLI::IsMember({"yes", "force"}));
    command->add_flag("--retry-failed", options->retry_failed,
                      "Try unchanged files again that failed before");
    set_body(*command, session, [options, &session] { return run(*options, session); });
}

}  // namespace ossuary::cli
