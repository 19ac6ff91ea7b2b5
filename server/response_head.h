#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "server/message.h"

namespace ossuary::server {

/// The bytes of an answer before its body: status line, the date, its fields, its content type, the
/// further `fields`, its length (none for 204 and 304), the empty line.
[[nodiscard]] std::string response_head(const Response& response, std::size_t body_size,
                                        const Fields& fields);

/// Whether the client takes answers as gzip.
[[nodiscard]] bool takes_gzip(std::string_view accept_encoding);

/// Whether compressing content of this type makes it much smaller.
[[nodiscard]] bool is_compressible(std::string_view content_type);

}  // namespace ossuary::server
