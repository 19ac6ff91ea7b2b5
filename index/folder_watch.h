#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <stop_token>
#include <vector>

#include "engine/core/result.h"

namespace ossuary::index {

struct FolderWatchOptions {
    /// After a change, so long without another is waited for: a file that is being copied counts
    /// once it is whole.
    std::chrono::milliseconds settle{2'000};
    /// But no longer than this in all, should something change again and again.
    std::chrono::milliseconds at_most{60'000};
    /// At least so often it is time to look, whatever the system tells: it tells nothing of what
    /// other machines do on a network's file system, nor of disks that are mounted.
    std::chrono::milliseconds rescan{900'000};
    /// Files whose changes do not count, with what SQLite writes beside them.
    std::vector<std::filesystem::path> ignored;
};

/// Tells when something below files and folders may have changed (Linux' inotify). Hidden names
/// (is_hidden_name) do not count; links to folders are followed.
class FolderWatch {
public:
    enum class Reason { kChange, kRescan, kStop };

    /// @param roots  files and folders; those that are not there are looked for at each rescan
    /// Errors: internal, where the system gives no inotify instance.
    static Result<FolderWatch> open(std::vector<std::filesystem::path> roots,
                                    FolderWatchOptions options = {});
    FolderWatch(FolderWatch&&) noexcept;
    FolderWatch& operator=(FolderWatch&&) noexcept;
    ~FolderWatch();

    /// Watches what has been added since. Call it before what is there is read, so that no change
    /// falls between.
    void refresh(const std::stop_token& stop = {});
    /// Until it is time to look again.
    Reason wait(const std::stop_token& stop);

    /// Folders of which the system tells no changes, as of the last refresh: on a network's file
    /// system, or beyond the number that may be watched (fs.inotify.max_user_watches).
    [[nodiscard]] const std::vector<std::filesystem::path>& untold() const;

private:
    struct Impl;
    explicit FolderWatch(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace ossuary::index
