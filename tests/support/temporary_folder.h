#pragma once

#include <filesystem>

namespace ossuary::test {

/// A folder of its own under the system's temporary one, removed at the end.
class TemporaryFolder {
public:
    /// Throws std::filesystem::filesystem_error where none can be made, which fails the test.
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

/// Makes a folder inside `parent` that nobody can read by its path, not even root: it lies deeper
/// than a path may be long. Returns the first folder of the way down.
std::filesystem::path make_unreadable_folder(const std::filesystem::path& parent);

}  // namespace ossuary::test
