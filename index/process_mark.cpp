#include "index/process_mark.h"

#include <unistd.h>

#include <atomic>
#include <fstream>
#include <sstream>

namespace ossuary::index {

namespace {

/// When a process began, in ticks since the boot: numbers of processes are used again, this is not.
/// Empty when there is none.
std::string start_of(const std::string& process) {
    std::ifstream file("/proc/" + process + "/stat");
    std::string line;
    if (!std::getline(file, line)) return {};
    // The second field is the program's name in parentheses and may hold anything.
    std::istringstream fields(line.substr(std::min(line.rfind(')') + 1, line.size())));
    std::string field;
    for (int number = 3; number <= 22; ++number) fields >> field;
    return field;
}

std::string boot() {
    std::ifstream file("/proc/sys/kernel/random/boot_id");
    std::string id;
    std::getline(file, id);
    return id;
}

}  // namespace

std::string process_mark() {
    static std::atomic<unsigned> count = 0;
    const std::string process = std::to_string(getpid());
    return boot() + ' ' + process + ' ' + start_of(process) + ' ' + std::to_string(++count);
}

bool process_runs(std::string_view mark) {
    std::istringstream words{std::string(mark)};
    std::string boot_id, process, start;
    words >> boot_id >> process >> start;
    if (start.empty() || process.find_first_not_of("0123456789") != std::string::npos) return false;
    return boot_id == boot() && start == start_of(process);
}

}  // namespace ossuary::index
