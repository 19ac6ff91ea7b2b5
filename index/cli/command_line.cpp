#include "index/cli/command_line.h"

#include <iostream>
#include <sstream>
#include <stop_token>

#include "index/cli/command.h"
#include "index/cli/console.h"
#include "index/cli/exit_code.h"
#include "index/cli/interrupt.h"
#include "index/cli/version.h"

namespace ossuary::cli {
namespace {

constexpr const char* kDescription =
    "Ossuary finds 3D models that are built like a given one, and those that stand like it.";

constexpr const char* kFooter =
    "Exit status: 0 done, 1 failed, 2 usage, 3 done but some models failed, 4 not a usable index.\n"
    "Data goes to stdout, progress and messages to stderr. NO_COLOR is honoured.";

}  // namespace

int run_command_line(int argc, char** argv) {
    CLI::App app(kDescription, "ossuary");
    app.footer(kFooter);
    app.require_subcommand(1);
    app.set_version_flag("--version", std::string("ossuary ") + std::string(kVersion));
    Session session;
    const InterruptGuard interrupt;
    session.stop = interrupt.stop_token();
    for (const auto add : {add_index, add_watch, add_search, add_compare, add_evaluate,
                           add_skeleton, add_thin, add_segment, add_evaluate_segmentation,
                           add_models, add_show, add_remove, add_up, add_verify, add_export}) {
        add(app, session);
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        // CLI11 prints help and version through the same road, with its own status 0.
        // Messages quote arguments, and a shell's * puts any file's name there.
        std::ostringstream out, err;
        const int status = app.exit(error, out, err);
        std::cout << terminal_lines(out.str());
        std::cerr << terminal_lines(err.str());
        return status == 0 ? 0 : static_cast<int>(ExitCode::kUsage);
    }
    std::cout.flush();
    if (!std::cout && session.exit_code == ExitCode::kDone) {
        std::cerr << "ossuary: file_unwritable: stdout could not be written\n";
        return static_cast<int>(ExitCode::kFailed);
    }
    return static_cast<int>(session.exit_code);
}

}  // namespace ossuary::cli
