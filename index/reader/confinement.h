#pragma once

#include <cstdint>
#include <string>

namespace ossuary::index {

/// What the reader may use for one file, beyond its program and libraries.
struct ConfinementLimits {
    std::uint64_t memory_bytes = 2ull << 30;  ///< address space
    std::uint64_t answer_bytes = 1ull << 30;  ///< the longest file that can be written
};

/// Whether this build can be held within limits: sanitizers need address space and system calls of
/// their own.
[[nodiscard]] bool can_be_confined();

/// Gives up, for good, all that reading one file into memory does not need: address space, long
/// files, open files, core dumps, and every system call but a few (seccomp). Opening files,
/// network, new processes are refused or end the process.
/// @returns what could not be given up; empty where all is well
[[nodiscard]] std::string confine(const ConfinementLimits& limits);

}  // namespace ossuary::index
