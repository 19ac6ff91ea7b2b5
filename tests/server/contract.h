#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace ossuary::test {

/// server/openapi.yaml as the server holds it.
const nlohmann::json& contract();

/// The part of the contract that a node refers to, or the node itself.
const nlohmann::json& resolved(const nlohmann::json& node);

/// A YAML document as JSON; plain scalars become null, booleans and numbers where they can.
/// Throws YAML::Exception for what is no YAML.
nlohmann::json parse_yaml(const std::string& text);

/// What is wrong with a value under a schema of the contract. Properties that the schema does not
/// name are wrong too, unless it has additionalProperties.
std::vector<std::string> schema_faults(const nlohmann::json& schema, const nlohmann::json& value);

}  // namespace ossuary::test
