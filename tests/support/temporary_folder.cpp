#include "tests/support/temporary_folder.h"

#include <fcntl.h>
#include <limits.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

namespace ossuary::test {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
    std::string pattern = (fs::temp_directory_path() / "ossuary-test-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) {
        throw fs::filesystem_error("no temporary folder can be made", pattern,
                                   std::error_code(errno, std::generic_category()));
    }
    path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

fs::path make_unreadable_folder(const fs::path& parent) {
    const std::string name(200, 'd');
    const auto fail = [&] {
        throw fs::filesystem_error("no deep folder can be made", parent,
                                   std::error_code(errno, std::generic_category()));
    };
    int here = open(parent.c_str(), O_DIRECTORY | O_CLOEXEC);
    if (here < 0) fail();
    for (std::size_t depth = 0; depth * (name.size() + 1) <= PATH_MAX; ++depth) {
        const bool made = mkdirat(here, name.c_str(), 0700) == 0;
        const int below = made ? openat(here, name.c_str(), O_DIRECTORY | O_CLOEXEC) : -1;
        close(here);
        if (below < 0) fail();
        here = below;
    }
    close(here);
    return parent / name;
}

}  // namespace ossuary::test
