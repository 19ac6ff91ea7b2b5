#include "tests/server/contract.h"

#include <yaml-cpp/yaml.h>

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "server/embedded.h"

namespace ossuary::test {
namespace {

nlohmann::json scalar(const YAML::Node& node) {
    const std::string text = node.Scalar();
    // yaml-cpp gives quoted and literal scalars the tag "!".
    if (node.Tag() == "!") return text;
    if (text == "true" || text == "false") return text == "true";
    const nlohmann::json number = nlohmann::json::parse(text, nullptr, false);
    return number.is_number() ? number : nlohmann::json(text);
}

nlohmann::json converted(const YAML::Node& node) {
    if (node.IsMap()) {
        nlohmann::json object = nlohmann::json::object();
        for (const auto& entry : node) object[entry.first.Scalar()] = converted(entry.second);
        return object;
    }
    if (node.IsSequence()) {
        nlohmann::json array = nlohmann::json::array();
        for (const auto& entry : node) array.push_back(converted(entry));
        return array;
    }
    return node.IsNull() ? nlohmann::json() : scalar(node);
}

/// Adds what a part of an allOf asks for: properties and the names of those that must be there.
void merge(nlohmann::json& whole, const nlohmann::json& part) {
    for (const auto& [key, value] : part.items()) {
        if (key == "properties" && whole.contains(key)) {
            whole[key].update(value);
        } else if (key == "required" && whole.contains(key)) {
            whole[key].insert(whole[key].end(), value.begin(), value.end());
        } else {
            whole[key] = value;
        }
    }
}

/// The schema with its allOf written out and with no room for other properties than its own:
/// "additionalProperties: false" beside an allOf would refuse the parts' properties.
nlohmann::json closed(const nlohmann::json& schema) {
    if (schema.is_array()) {
        nlohmann::json all = nlohmann::json::array();
        for (const nlohmann::json& each : schema) all.push_back(closed(each));
        return all;
    }
    if (!schema.is_object()) return schema;
    nlohmann::json whole = nlohmann::json::object();
    if (schema.contains("allOf")) {
        for (const nlohmann::json& part : schema["allOf"]) merge(whole, closed(resolved(part)));
    }
    nlohmann::json own = nlohmann::json::object();
    for (const auto& [key, value] : schema.items()) {
        // Data, not schemas.
        const bool data = key == "enum" || key == "const" || key == "example" || key == "required";
        if (key != "allOf") own[key] = data ? value : closed(value);
    }
    merge(whole, own);
    if (whole.contains("properties") && whole["properties"].is_object() &&
        !whole.contains("additionalProperties")) {
        whole["additionalProperties"] = false;
    }
    return whole;
}

const nlohmann::json& closed_components() {
    static const nlohmann::json components = {
        {"schemas", closed(contract()["components"]["schemas"])}};
    return components;
}

}  // namespace

const nlohmann::json& contract() {
    static const nlohmann::json document = parse_yaml(std::string(server::kOpenApiDocument));
    return document;
}

const nlohmann::json& resolved(const nlohmann::json& node) {
    if (!node.contains("$ref")) return node;
    return contract().at(nlohmann::json::json_pointer(node["$ref"].get<std::string>().substr(1)));
}

nlohmann::json parse_yaml(const std::string& text) { return converted(YAML::Load(text)); }

std::vector<std::string> schema_faults(const nlohmann::json& schema, const nlohmann::json& value) {
    // References lead into the document that they stand in, so the parts come along.
    nlohmann::json root = closed(resolved(schema));
    root["components"] = closed_components();
    valijson::Schema parsed;
    valijson::SchemaParser().populateSchema(valijson::adapters::NlohmannJsonAdapter(root), parsed);
    valijson::ValidationResults results;
    valijson::Validator().validate(parsed, valijson::adapters::NlohmannJsonAdapter(value),
                                   &results);
    std::vector<std::string> faults;
    valijson::ValidationResults::Error error;
    while (results.popError(error)) {
        std::string where;
        for (const std::string& step : error.context) where += step;
        faults.push_back(where + ": " + error.description);
    }
    return faults;
}

}  // namespace ossuary::test
