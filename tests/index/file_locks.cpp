#include "tests/index/file_locks.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ossuary::test {

bool holds_lock(const std::filesystem::path& index) {
    // SQLite's file format, "Locks": the 510 bytes after the pending and the reserved byte.
    constexpr off_t kSharedFirst = 0x40000002;
    constexpr off_t kSharedSize = 510;
    const std::string name = index.string();
    // A process is never in the way of its own locks, and would lose them here; so a child asks.
    const pid_t child = fork();
    if (child == 0) {
        const int file = open(name.c_str(), O_RDWR);
        struct flock lock {};
        lock.l_type = F_WRLCK;
        lock.l_whence = SEEK_SET;
        lock.l_start = kSharedFirst;
        lock.l_len = kSharedSize;
        if (file < 0 || fcntl(file, F_GETLK, &lock) != 0) _exit(2);
        _exit(lock.l_type == F_UNLCK ? 0 : 1);
    }
    int status = 0;
    EXPECT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) != 2) << "locks cannot be asked for";
    return WIFEXITED(status) && WEXITSTATUS(status) == 1;
}

}  // namespace ossuary::test
