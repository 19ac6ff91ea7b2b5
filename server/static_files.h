#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "engine/core/result.h"
#include "server/message.h"

namespace ossuary::server {

/// The gallery's built files, read into memory once: nothing that a client says ever becomes a path
/// on the disk, so there is nothing to climb out of.
class StaticFiles {
public:
    /// No files at all.
    StaticFiles() = default;
    /// Reads a folder: regular files with known endings, symbolic links left out, at most 64 MB.
    /// Errors: file_not_found without an index.html, file_unreadable, file_too_large.
    static Result<StaticFiles> load(const std::filesystem::path& folder);

    /// The file of that path, the start page for `/`; none for anything else. (The gallery keeps
    /// its own pages behind the `#`, so no other path needs the start page.)
    [[nodiscard]] std::optional<Response> find(const RequestHead& head) const;
    [[nodiscard]] std::size_t size() const { return files_.size(); }

private:
    struct File {
        std::string content_type;
        std::string content;
        std::string etag;
        bool immutable = false;  ///< its name changes with its content
    };
    std::map<std::string, File, std::less<>> files_;  ///< by path, with the leading slash
};

/// The content type of a file name, empty for endings that are not served.
[[nodiscard]] std::string_view content_type_of(std::string_view name);

/// Whether the name carries a hash of the content, as the build writes them: index-B4x_9dKq.js.
[[nodiscard]] bool is_hashed_name(std::string_view name);

}  // namespace ossuary::server
