#pragma once

namespace ossuary::cli {

/// Parses what the program was started with and runs the command that it names.
/// @return the program's exit status
int run_command_line(int argc, char** argv);

}  // namespace ossuary::cli
