#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "engine/core/text.h"

namespace ossuary::index {

/// `document` as text: the one way in which this project writes JSON (the test `layering` looks for
/// others). Strings that are not UTF-8 become so as in `valid_utf8`, and none controls a terminal.
/// @param indent  spaces a level; -1 = everything on one line
template <typename Json>
[[nodiscard]] std::string json_text(const Json& document, int indent = -1) {
    return escape_json_controls(document.dump(indent, ' ', false, Json::error_handler_t::replace));
}

}  // namespace ossuary::index
