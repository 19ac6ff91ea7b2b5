#include "tests/support/benchmark_data.h"

#include <cstdlib>

namespace ossuary::test {

std::optional<std::filesystem::path> benchmark_data() {
    namespace fs = std::filesystem;
    std::error_code ignored;
    fs::path folder;
    if (const char* named = std::getenv("OSSUARY_DATA"); named != nullptr && *named != '\0') {
        folder = named;
    } else {
        folder = fs::temp_directory_path(ignored) / "ossuary-data";
    }
    if (!fs::is_directory(folder / "princeton-segmentation" / "off", ignored)) return std::nullopt;
    return folder;
}

}  // namespace ossuary::test
