#pragma once

#include <string>
#include <string_view>

namespace ossuary::test {

/// One gzip member with these bytes.
std::string gzipped(std::string_view bytes);

}  // namespace ossuary::test
