#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <string_view>

#include "engine/core/result.h"

namespace ossuary {

/// The bytes of a file, in memory of their own: a file that shrinks under a memory map kills the
/// process.
class WholeFile {
public:
    WholeFile() = default;
    /// For the caller to fill, not set to anything.
    explicit WholeFile(std::size_t size)
        : bytes_(std::make_unique_for_overwrite<char[]>(size)), size_(size) {}

    [[nodiscard]] std::string_view view() const { return {bytes_.get(), size_}; }
    [[nodiscard]] char* data() { return bytes_.get(); }
    [[nodiscard]] std::size_t size() const { return size_; }
    void shorten(std::size_t size) { size_ = size < size_ ? size : size_; }

private:
    std::unique_ptr<char[]> bytes_;
    std::size_t size_ = 0;
};

/// Reads a regular file of at most so many bytes.
/// Errors: file_not_found, file_unreadable (no regular file, or it cannot be read), file_too_large.
Result<WholeFile> read_whole_file(
    const std::filesystem::path& path,
    std::uint64_t max_bytes = std::numeric_limits<std::uint64_t>::max());

/// Writes a file anew. Errors: file_unwritable, with the system's reason.
Result<void> write_whole_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace ossuary
