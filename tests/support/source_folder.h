#pragma once

#include <filesystem>

namespace ossuary::test {

/// The root of the source tree that the tests were built from.
std::filesystem::path source_folder();

}  // namespace ossuary::test
