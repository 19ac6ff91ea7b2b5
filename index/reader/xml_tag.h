#pragma once

#include <string_view>

namespace ossuary::index {

/// The value of an attribute in the text of a tag; empty where it has none.
[[nodiscard]] std::string_view xml_attribute(std::string_view tag, std::string_view name);

/// The first tag of a name in a document, without its brackets; empty where there is none.
[[nodiscard]] std::string_view first_tag(std::string_view document, std::string_view name);

}  // namespace ossuary::index
