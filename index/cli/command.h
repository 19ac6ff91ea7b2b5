#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <stop_token>

#include "index/cli/exit_code.h"
#include "index/model_reader.h"

namespace ossuary::cli {

/// What every command is given: where to leave its exit code, and whether the user wants it to end.
struct Session {
    ExitCode exit_code = ExitCode::kDone;
    std::stop_token stop;
    bool json = false;  ///< --json: data on stdout as one JSON document
    int jobs = 0;       ///< --jobs: worker threads, 0 = all
    /// Reads model files for all commands.
    std::shared_ptr<index::ModelReader> reader = std::make_shared<index::ModelReader>();
};

using CommandBody = std::function<Result<ExitCode>()>;

/// Adds a subcommand that runs `body` and turns an Error into a message on stderr and an exit code.
/// `--json` and `--jobs` are added to it, since every command has them.
void set_body(CLI::App& command, Session& session, CommandBody body);

/// Prints an error for people, or as JSON where the session wants that, on stderr.
void print_error(const Error& error, const Session& session);

/// Prints a document on stdout, indented, with a line end.
void print_json(const nlohmann::json& document);

// One function a command, each in its own file.
void add_index(CLI::App& app, Session& session);
void add_watch(CLI::App& app, Session& session);
void add_search(CLI::App& app, Session& session);
void add_compare(CLI::App& app, Session& session);
void add_evaluate(CLI::App& app, Session& session);
void add_skeleton(CLI::App& app, Session& session);
void add_thin(CLI::App& app, Session& session);
void add_segment(CLI::App& app, Session& session);
void add_evaluate_segmentation(CLI::App& app, Session& session);
void add_models(CLI::App& app, Session& session);
void add_show(CLI::App& app, Session& session);
void add_remove(CLI::App& app, Session& session);
void add_up(CLI::App& app, Session& session);
void add_verify(CLI::App& app, Session& session);
void add_export(CLI::App& app, Session& session);

}  // namespace ossuary::cli
