#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace ossuary::test {

/// What a program left when it ended.
struct ProgramResult {
    int exit_status = -1;
    std::string out;
    std::string err;

    /// stdout as JSON; a test failure and null when it is not.
    [[nodiscard]] nlohmann::json json() const;
};

/// Runs the `ossuary` program with these arguments and waits for its end. What it prints passes
/// through files in `scratch`.
ProgramResult run_ossuary(const std::vector<std::string>& arguments,
                          const std::filesystem::path& scratch);

}  // namespace ossuary::test
