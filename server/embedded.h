#pragma once

#include <string_view>

namespace ossuary::server {

/// server/openapi.yaml as it was at build time.
extern const std::string_view kOpenApiDocument;

}  // namespace ossuary::server
