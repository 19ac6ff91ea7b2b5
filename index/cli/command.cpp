#include "index/cli/command.h"

#include <fmt/format.h>

#include <iostream>
#include <nlohmann/json.hpp>
#include <utility>

#include "index/cli/console.h"
#include "index/json_text.h"

namespace ossuary::cli {

void set_body(CLI::App& command, Session& session, CommandBody body) {
    command.add_flag("--json", session.json, "Print data as JSON on stdout");
    command.add_option("--jobs,-j", session.jobs, "Worker threads (0 = all)")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    command.callback([&session, body = std::move(body)] {
        const Result<ExitCode> outcome = body();
        if (outcome.ok()) {
            session.exit_code = *outcome;
        } else {
            print_error(outcome.error(), session);
            session.exit_code = exit_code_for(outcome.error().code);
        }
    });
}

void print_error(const Error& error, const Session& session) {
    if (session.json) {
        const nlohmann::json document = {
            {"error", {{"code", to_string(error.code)}, {"message", error.message}}}};
        std::cerr << index::json_text(document) << '\n';
        return;
    }
    std::cerr << "ossuary: " << style(Style::kError) << to_string(error.code)
              << style(Style::kPlain) << terminal_format(": {}\n", error.message);
}

void print_json(const nlohmann::json& document) {
    std::cout << index::json_text(document, 2) << '\n';
}

}  // namespace ossuary::cli
