#include <fmt/format.h>

#include <chrono>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "index/cli/command.h"
#include "index/cli/console.h"
#include "index/cli/index_arguments.h"
#include "index/json_text.h"
#include "index/keep_indexed.h"
#include "index/presentation.h"
#include "index/timestamp.h"

namespace ossuary::cli {
namespace {

struct WatchArguments {
    IndexArguments indexing;
    bool keep_gone = false;
    double settle_seconds = 2.0;
    double rescan_seconds = 900.0;
};

/// A line for each run that changed something, and for whatever needs attention.
class ConsoleRuns : public index::KeepSink {
public:
    ConsoleRuns(const IndexArguments& arguments, const Session& session)
        : arguments_(arguments), session_(session) {}

    void failed(const index::Failure& failure) override {
        std::cerr << terminal_format("{}: {}\n", failure.code, failure.message);
    }
    void ran(const index::IndexOutcome& outcome) override {
        failure_.clear();
        const bool first = std::exchange(first_, false);
        if (first || changed(outcome)) say(outcome);
        std::size_t refused = 0;
        for (const index::PruneRefusal& refusal : outcome.refusals) refused += refusal.models;
        if (refused != refused_) print_refusals(outcome.refusals, session_);
        refused_ = refused;
    }
    void run_failed(const Error& error) override {
        // There is another run every few seconds.
        if (error.message != failure_) print_error(error, session_);
        failure_ = error.message;
    }
    void missing(const std::vector<std::filesystem::path>& paths) override {
        for (const auto& path : paths) {
            std::cerr << terminal_format("{}: not there; looked for from time to time\n",
                                         path.string());
        }
    }
    void untold(const std::vector<std::filesystem::path>& folders) override {
        if (folders.empty()) return;
        std::cerr << terminal_format(
            "{}{}: the system does not tell what changes there; looked at from time to time\n",
            folders.front().string(),
            folders.size() > 1 ? fmt::format(" and {} more folders", folders.size() - 1) : "");
    }

private:
    static bool changed(const index::IndexOutcome& outcome) {
        return outcome.indexed + outcome.moved + outcome.classified + outcome.turned +
                   outcome.pruned + outcome.failed >
               0;
    }
    void say(const index::IndexOutcome& outcome) const {
        if (session_.json) {
            std::cout << index::json_text(index::to_json(outcome)) << std::endl;
        } else {
            std::cout << terminal_format("{} {}: {} of {} files in {}\n", index::utc_now(),
                                         arguments_.index_path, outcome_text(outcome),
                                         outcome.files, duration_text(outcome.seconds))
                      << std::flush;
        }
    }

    const IndexArguments& arguments_;
    const Session& session_;
    bool first_ = true;
    std::size_t refused_ = 0;
    std::string failure_;  ///< of the last run, where it failed
};

std::chrono::milliseconds milliseconds(double seconds) {
    return std::chrono::milliseconds(static_cast<std::int64_t>(1000.0 * seconds));
}

Result<ExitCode> run(const WatchArguments& arguments, const Session& session) {
    const IndexArguments& indexing = arguments.indexing;
    const Result<index::IndexParameters> parameters = indexing.parameters();
    if (!parameters.ok()) return parameters.error();
    Result<index::IndexOptions> options = indexing.options(session);
    if (!options.ok()) return options.error();
    options->prune = arguments.keep_gone ? index::Prune::kNo : index::Prune::kYes;

    Result<index::Store> store = index::Store::create_or_open(indexing.index_path, *parameters);
    if (!store.ok()) return store.error();
    index::KeepOptions keep;
    keep.folders.settle = milliseconds(arguments.settle_seconds);
    keep.folders.rescan = milliseconds(arguments.rescan_seconds);
    keep.folders.ignored = {indexing.index_path};
    ConsoleRuns runs(indexing, session);
    const auto kept = index::keep_indexed(*store, *options, keep, runs, session.stop);
    if (!kept.ok()) return kept.error();
    return ExitCode::kDone;
}

}  // namespace

void add_watch(CLI::App& app, Session& session) {
    auto options = std::make_shared<WatchArguments>();
    CLI::App* command = app.add_subcommand(
        "watch",
        "Keep an index up to date with folders until interrupted; with --json, a line of "
        "JSON for each run that changed something");
    options->indexing.add_to(*command);
    command->add_flag("--keep-gone", options->keep_gone,
                      "Keep models in the index whose files are gone. Those of a PATH that holds "
                      "no model file any more, as when a disk is not mounted, stay in any case");
    command
        ->add_option("--settle", options->settle_seconds,
                     "Seconds without a change before models are indexed")
        ->check(CLI::Range(0.0, 3600.0))
        ->capture_default_str();
    command
        ->add_option("--rescan", options->rescan_seconds,
                     "Seconds after which folders are looked at without a change; that alone finds "
                     "what changes on a network's file systems")
        ->check(CLI::Range(1.0, 604800.0))
        ->capture_default_str();
    set_body(*command, session, [options, &session] { return run(*options, session); });
}

}  // namespace ossuary::cli
