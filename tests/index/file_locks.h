#pragma once

#include <filesystem>

namespace ossuary::test {

/// Whether a connection of this process still has SQLite's shared lock on the index, as another
/// process sees it. With an index in WAL mode every connection has it until it is closed.
bool holds_lock(const std::filesystem::path& index);

}  // namespace ossuary::test
