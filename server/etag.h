#pragma once

#include <string>
#include <string_view>

#include "server/message.h"

namespace ossuary::server {

/// A weak entity tag of the bytes (weak, because they may be sent compressed or not).
[[nodiscard]] std::string etag_of(std::string_view bytes);

/// Whether If-None-Match names the tag.
[[nodiscard]] bool is_current(const RequestHead& head, std::string_view etag);

/// Adds the tag of the body, or of `etag` where one is given, and turns the answer into a 304 when
/// the client has it already. Asks caches to revalidate.
[[nodiscard]] Response conditional(const RequestHead& head, Response response,
                                   std::string etag = {});

/// The 304 for a tag that `is_current`.
[[nodiscard]] Response not_modified(std::string etag);

}  // namespace ossuary::server
