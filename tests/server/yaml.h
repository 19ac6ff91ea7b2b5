#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

namespace ossuary::test {

/// Reads the part of YAML that server/openapi.yaml is written in: block mappings and sequences,
/// flow collections, quoted and one-line plain scalars, literal blocks, anchors on block
/// collections. Throws std::runtime_error with the line for anything else.
nlohmann::json parse_yaml(std::string_view text);

}  // namespace ossuary::test
