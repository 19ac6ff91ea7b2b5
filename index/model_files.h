#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/ranking/classification.h"
#include "index/glob.h"

namespace ossuary::index {

/// The absolute, normalised form in which an index keeps paths (links are not followed).
[[nodiscard]] std::filesystem::path index_path(const std::filesystem::path& path);

/// Whether a file or folder is one that systems keep for themselves: a name with a dot first, and
/// those of Synology's, QNAP's, Windows', macOS' and ext4's housekeeping (`@eaDir`, `#recycle`,
/// `$RECYCLE.BIN`, `System Volume Information`, `__MACOSX`, `lost+found`; any case).
[[nodiscard]] bool is_hidden_name(std::string_view name);

/// What a walk leaves out below the folders that it is given.
struct WalkOptions {
    std::vector<Glob> exclude;  ///< files and folders that match one are passed over
};

/// How much was passed over, and why.
struct PassedOver {
    std::size_t hidden = 0;        ///< files and folders with a hidden name
    std::size_t excluded = 0;      ///< files and folders that match a pattern
    std::size_t seen_before = 0;   ///< links (or paths) to what is taken under another path
    std::size_t broken_links = 0;  ///< links that lead nowhere
    std::size_t special = 0;       ///< pipes, sockets and devices named like models
    std::size_t other_files = 0;  ///< files that are no models by their names, archives without any
};

/// A folder that could not be read.
struct UnreadableFolder {
    std::filesystem::path path;
    Error error;
};

/// What a walk has found; every path as index_path.
struct FoundFiles {
    std::vector<std::filesystem::path> files;  ///< sorted by their bytes, without repetition
    PassedOver passed_over;
    std::vector<UnreadableFolder> unreadable;
    std::vector<std::filesystem::path> missing;       ///< named, and not there
    std::vector<std::filesystem::path> seen_before;   ///< the links so counted
    std::vector<std::filesystem::path> broken_links;  ///< the links so counted
    /// What has its models among `files` in its place (open_files.h), sorted.
    std::vector<std::filesystem::path> opened;
};

/// All model files that `paths` name: files as they are, and folders with the model files below
/// them. Hidden names are passed over unless named in `paths`, patterns always, but for a folder in
/// `paths` itself. Links to folders are followed after everything else, each folder once, and not
/// back to a folder above; a file that several links lead to is taken once, under its own path if
/// that is found. A hard link is a file of its own.
/// Errors: cancelled.
Result<FoundFiles> find_model_files(const std::vector<std::filesystem::path>& paths,
                                    const WalkOptions& options = {}, std::stop_token stop = {});

/// Whether a walk of `roots` (as index_path) passes `path` over by its name or that of a folder on
/// the way; false for what lies under none of them.
[[nodiscard]] bool is_passed_over(const std::filesystem::path& path,
                                  const std::vector<std::filesystem::path>& roots,
                                  const WalkOptions& options);

/// True when `path` is one of `roots` or lies below one; all as index_path.
[[nodiscard]] bool is_under(const std::filesystem::path& path,
                            const std::vector<std::filesystem::path>& roots);

/// Class of each file name (ModelPlace::file_name) that a classification names. An id stands for
/// the first of its candidate names that is among `files`.
[[nodiscard]] std::map<std::string, std::string> classes_by_file_name(
    const ranking::Classification& classification, const std::vector<std::filesystem::path>& files);

}  // namespace ossuary::index
