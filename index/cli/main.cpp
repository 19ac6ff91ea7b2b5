#include <malloc.h>

#include <exception>
#include <iostream>
#include <new>

#include "index/cli/command_line.h"
#include "index/cli/console.h"
#include "index/cli/exit_code.h"

namespace {

/// What one stage frees the next one takes: given back to the system and asked for again, pages
/// were a twelfth of the processor time of indexing.
void keep_freed_memory() {
#ifdef __GLIBC__
    mallopt(M_MMAP_THRESHOLD, 32 << 20);
    mallopt(M_TRIM_THRESHOLD, 256 << 20);
    mallopt(M_TOP_PAD, 16 << 20);
#endif
}

}  // namespace

int main(int argc, char** argv) {
    keep_freed_memory();
    try {
        return ossuary::cli::run_command_line(argc, argv);
    } catch (const std::bad_alloc&) {
        std::cerr << "ossuary: out_of_memory: the machine has no memory left for this\n";
    } catch (const std::exception& error) {
        std::cerr << "ossuary: internal: " << ossuary::terminal_text(error.what()) << '\n';
    }
    return static_cast<int>(ossuary::cli::ExitCode::kFailed);
}
