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

}  // namespace ossuary::test
