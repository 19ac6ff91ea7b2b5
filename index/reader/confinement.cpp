#include "index/reader/confinement.h"

#include <fcntl.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/resource.h>

#include <array>
#include <cerrno>
#include <initializer_list>
#include <memory>

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define OSSUARY_SANITIZED 1
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define OSSUARY_SANITIZED 1
#endif
#ifndef OSSUARY_SANITIZED
#define OSSUARY_SANITIZED 0
#endif

namespace ossuary::index {
namespace {

struct ReleaseFilter {
    void operator()(void* filter) const { seccomp_release(filter); }
};
using Filter = std::unique_ptr<void, ReleaseFilter>;

bool limit(__rlimit_resource resource, std::uint64_t most) {
    rlimit now{};
    if (getrlimit(resource, &now) != 0) return false;
    if (now.rlim_max != RLIM_INFINITY && most > now.rlim_max) most = now.rlim_max;
    const rlimit limits{most, most};
    return setrlimit(resource, &limits) == 0;
}

/// Memory, the two kinds of files that are handed over, messages, and ending.
constexpr std::array kAllowed = {
    SCMP_SYS(read),
    SCMP_SYS(write),
    SCMP_SYS(pread64),
    SCMP_SYS(pwrite64),
    SCMP_SYS(lseek),
    SCMP_SYS(close),
    SCMP_SYS(fstat),
    SCMP_SYS(munmap),
    SCMP_SYS(mremap),
    SCMP_SYS(madvise),
    SCMP_SYS(brk),
    SCMP_SYS(futex),
    SCMP_SYS(recvmsg),
    SCMP_SYS(sendmsg),
    SCMP_SYS(clock_gettime),
    SCMP_SYS(gettimeofday),
    SCMP_SYS(time),
    SCMP_SYS(getrandom),
    SCMP_SYS(sched_yield),
    SCMP_SYS(restart_syscall),
    SCMP_SYS(rt_sigprocmask),
    SCMP_SYS(rt_sigaction),
    SCMP_SYS(rt_sigreturn),
    SCMP_SYS(sigaltstack),
    SCMP_SYS(getpid),
    SCMP_SYS(getppid),
    SCMP_SYS(gettid),
    SCMP_SYS(exit),
    SCMP_SYS(exit_group),
};

bool allow(void* filter) {
    bool fine = true;
    for (const int call : kAllowed) fine &= seccomp_rule_add(filter, SCMP_ACT_ALLOW, call, 0) == 0;
    // Memory, but none that can be run.
    for (const int call : {SCMP_SYS(mmap), SCMP_SYS(mprotect)}) {
        fine &= seccomp_rule_add(filter, SCMP_ACT_ALLOW, call, 1,
                                 SCMP_A2(SCMP_CMP_MASKED_EQ, PROT_EXEC, 0)) == 0;
    }
    // fstat, as the C library calls it.
    fine &= seccomp_rule_add(filter, SCMP_ACT_ALLOW, SCMP_SYS(newfstatat), 1,
                             SCMP_A3(SCMP_CMP_MASKED_EQ, AT_EMPTY_PATH, AT_EMPTY_PATH)) == 0;
    // Ending itself.
    fine &= seccomp_rule_add(filter, SCMP_ACT_ALLOW, SCMP_SYS(tgkill), 1,
                             SCMP_A2(SCMP_CMP_EQ, 6 /* SIGABRT */, 0)) == 0;
    return fine;
}

}  // namespace

bool can_be_confined() { return OSSUARY_SANITIZED == 0; }

std::string confine(const ConfinementLimits& limits) {
    constexpr std::uint64_t kOpenFiles = 16;
    if (!limit(RLIMIT_CORE, 0) || !limit(RLIMIT_FSIZE, limits.answer_bytes) ||
        !limit(RLIMIT_NOFILE, kOpenFiles)) {
        return "its limits could not be set";
    }
    if (!can_be_confined()) return {};
    if (!limit(RLIMIT_AS, limits.memory_bytes)) return "its memory could not be limited";
    // Refused rather than ended: libraries try things that they can do without (libuuid a socket).
    const Filter filter(seccomp_init(SCMP_ACT_ERRNO(EACCES)));
    if (!filter || !allow(filter.get()) || seccomp_load(filter.get()) != 0) {
        return "its system calls could not be limited";
    }
    return {};
}

}  // namespace ossuary::index
