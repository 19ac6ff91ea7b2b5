#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "engine/core/result.h"

namespace ossuary::test {

/// One file of the corpus of odd and bad OFF files, with what its `.expect` file says of it.
struct OffCase {
    std::string name;
    std::string bytes;
    // for files that can be read
    std::size_t vertices = 0;
    std::size_t faces = 0;
    std::size_t triangles = 0;
    std::map<std::string, std::size_t> warnings;  ///< code → count
    // for files that cannot
    std::string code;
    std::size_t line = 0;  ///< 0 where the message names none
    std::string says;      ///< part of the message
};

/// How GoogleTest names and prints a case.
void PrintTo(const OffCase& off_case, std::ostream* out);

/// The cases of tests/corpus/off/`folder` in the order of their names.
std::vector<OffCase> off_cases(const std::string& folder);

}  // namespace ossuary::test
