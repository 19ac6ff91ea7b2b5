#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "engine/core/result.h"

// Private to the store: the index as a file, before and beside SQLite. Nothing here or elsewhere in
// the program may open the index, its -wal or its -shm but through SQLite: POSIX gives up all locks
// that a process holds on a file when it closes any descriptor of that file, so that one stream
// opened and closed beside a connection leaves the connection without its locks
// (https://sqlite.org/howtocorrupt.html, section 2.2). SQLite keeps account of its own descriptors.

namespace ossuary::index {

/// What stands at a path, told from its first hundred bytes without opening it as a database.
enum class FileKind { kMissing, kEmpty, kIndex };

/// Errors: index_foreign for anything else, index_newer, index_io when it cannot be read.
Result<FileKind> inspect_file(const std::filesystem::path& path);

Error foreign_index(const std::filesystem::path& path, std::string_view found);
Error newer_index(const std::filesystem::path& path, std::int64_t version);

/// `path` as an SQLite "file:" URI with this query.
std::string file_uri(const std::filesystem::path& path, std::string_view query);

/// True when nothing waits in the write-ahead log, so that the file alone is the index.
bool log_is_empty(const std::filesystem::path& path);

/// Which file stands at a path, whatever its name.
struct FileId {
    dev_t device = 0;
    ino_t inode = 0;
    bool operator==(const FileId&) const = default;
};
/// None where there is no file. Errors: index_io when that cannot be told.
Result<std::optional<FileId>> file_at(const std::filesystem::path& path);

/// Whether a running program uses the log beside `path` for another file, one that stood here
/// before. SQLite goes by names alone: whoever opens the new file would read that log into it. To
/// be asked once this process has a connection to `path`; false where the system does not tell.
bool log_serves_another_file(const std::filesystem::path& path);

/// Whether a running program uses the log beside `path` at all; false where the system does not
/// tell.
bool log_is_in_use(const std::filesystem::path& path);

}  // namespace ossuary::index
