#include <exception>
#include <iostream>
#include <new>

#include "index/cli/command_line.h"
#include "index/cli/console.h"
#include "index/cli/exit_code.h"

int main(int argc, char** argv) {
    try {
        return ossuary::cli::run_command_line(argc, argv);
    } catch (const std::bad_alloc&) {
        std::cerr << "ossuary: out_of_memory: the machine has no memory left for this\n";
    } catch (const std::exception& error) {
        std::cerr << "ossuary: internal: " << ossuary::terminal_text(error.what()) << '\n';
    }
    return static_cast<int>(ossuary::cli::ExitCode::kFailed);
}
