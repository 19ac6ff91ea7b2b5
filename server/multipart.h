#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "server/request_head.h"

namespace ossuary::server {

/// One part of a form.
struct FormPart {
    std::string name;
    std::string file_name;     ///< without folders; empty where none was sent
    std::string_view content;  ///< within the body that was parsed
};

/// The parts of a multipart/form-data body (RFC 7578), at most 32 of them.
/// @param content_type  the request's Content-Type, with its boundary
Checked<std::vector<FormPart>> parse_form(std::string_view content_type, std::string_view body);

/// A media type without its parameters, in lower case: "multipart/form-data".
[[nodiscard]] std::string media_type(std::string_view content_type);

}  // namespace ossuary::server
