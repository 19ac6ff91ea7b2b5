#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "engine/core/mutex.h"
#include "engine/core/result.h"
#include "index/store_connection.h"
#include "index/store_file.h"

// Private to the store.

namespace ossuary::index {

/// The file at one path as the stores of this process have it open. When another file takes its
/// place, or it is removed, all of them let go of it together before any opens the new one: SQLite
/// names log and locks after the path, so that old and new must never be open at once.
class IndexFile {
public:
    /// The one for a path; stores of one path share it.
    static std::shared_ptr<IndexFile> at(const std::filesystem::path& path);
    explicit IndexFile(std::filesystem::path path) : path_(std::move(path)) {}

    /// Held shared while a connection is in use, alone for everything below but `stands`.
    SharedMutex& gate() OSSUARY_RETURNS_MUTEX(gate_) { return gate_; }
    /// For what is called by Store::Impl::locked, which holds the gate.
    void is_in_use() const OSSUARY_ASSERTS_SHARED(gate_) {}
    /// Whether the path still names the file that is open.
    [[nodiscard]] bool stands() const OSSUARY_REQUIRES_SHARED(gate_);
    /// How many files have taken the place of another at this path since it was first opened.
    [[nodiscard]] std::uint64_t replacements() const OSSUARY_REQUIRES_SHARED(gate_) {
        return replacements_;
    }

    /// Opens a connection to the file that stands there now, and remembers where it is kept. When
    /// the file was replaced, all connections to the earlier one are closed first.
    Result<void> open(std::unique_ptr<Connection>& holder, Access access) OSSUARY_REQUIRES(gate_);
    /// Closes a connection for good.
    void close(std::unique_ptr<Connection>& holder) OSSUARY_REQUIRES(gate_);
    /// Closes all connections if the file does not stand any more.
    void let_go_of_replaced() OSSUARY_REQUIRES(gate_);

private:
    const std::filesystem::path path_;
    SharedMutex gate_;
    std::optional<FileId> file_ OSSUARY_GUARDED_BY(gate_);  ///< none while nothing is open
    std::uint64_t replacements_ OSSUARY_GUARDED_BY(gate_) = 0;
    /// Of the open connections.
    std::vector<std::unique_ptr<Connection>*> holders_ OSSUARY_GUARDED_BY(gate_);
};

}  // namespace ossuary::index
