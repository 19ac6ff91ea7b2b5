#pragma once

#include <filesystem>
#include <optional>

namespace ossuary::test {

/// The folder of the public benchmark collections (`princeton-segmentation/`,
/// `princeton-shape-train/`): OSSUARY_DATA, else ossuary-data under the system's temporary folder.
/// Empty where neither has them; tests then skip.
std::optional<std::filesystem::path> benchmark_data();

}  // namespace ossuary::test

/// Skips the current test with a plain message where the benchmark collections are not at hand.
#define OSSUARY_REQUIRE_BENCHMARK_DATA(variable)                                           \
    const auto variable##_or_none = ::ossuary::test::benchmark_data();                     \
    if (!variable##_or_none) GTEST_SKIP() << "benchmark data not found: set OSSUARY_DATA"; \
    const std::filesystem::path& variable = *variable##_or_none
