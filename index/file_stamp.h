#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace ossuary::index {

/// Tells whether a file was written to or replaced between two looks at it.
struct FileStamp {
    std::uint64_t device = 0;
    std::uint64_t number = 0;  ///< of the file on it
    std::uint64_t size = 0;
    std::int64_t written_ns = 0;  ///< when its contents last changed, as the system says

    bool operator==(const FileStamp&) const = default;
};

/// None where no file is there. Links are followed.
[[nodiscard]] std::optional<FileStamp> stamp_of(const std::filesystem::path& path);

}  // namespace ossuary::index
